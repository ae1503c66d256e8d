# SPDX-License-Identifier: MIT
class_name PanelLayer
extends OpenXRCompositionLayerQuad
## Shows the open menu once more as a layer that the headset's runtime draws itself, sharper than
## what goes through the eyes' pictures; where the runtime cannot, the panel in the world is all
## there is. Child of the origin, like the menu.
##
## Off unless asked for: the layer lies over the pointer's mark and the ring that a gaze fills, and
## those who look on do not see it.

@export var menu: XrMenu
@export var enabled: bool = false

# The runtime takes a viewport for itself: the panel's own stays with the panel.
var _copy := SubViewport.new()
var _picture := TextureRect.new()


func _ready() -> void:
	_copy.disable_3d = true
	_copy.transparent_bg = true
	_copy.render_target_update_mode = SubViewport.UPDATE_DISABLED
	_copy.add_child(_picture)
	add_child(_copy)
	alpha_blend = true
	visible = false
	menu.opened.connect(_on_opened)
	menu.closed.connect(_on_closed)


func _process(_delta: float) -> void:
	if visible:
		var flat := menu.surface.picture
		global_transform = flat.global_transform


## Does the runtime draw the menu now?
func is_shown() -> bool:
	return visible


func _on_opened() -> void:
	if not enabled or not is_natively_supported():
		return
	var flat := menu.surface.picture
	_copy.size = flat.pixels
	_picture.size = flat.pixels
	_picture.texture = flat.viewport.get_texture()
	_copy.render_target_update_mode = SubViewport.UPDATE_ALWAYS
	layer_viewport = _copy
	quad_size = flat.get_extent()
	global_transform = flat.global_transform
	visible = true


func _on_closed() -> void:
	visible = false
	_copy.render_target_update_mode = SubViewport.UPDATE_DISABLED
