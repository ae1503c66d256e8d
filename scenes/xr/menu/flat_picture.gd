# SPDX-License-Identifier: MIT
class_name FlatPicture
extends MeshInstance3D
## A 2D scene on an upright quad in the world. It is drawn only when redraw() asks for it.

const SHADER: Shader = preload("res://scenes/xr/menu/flat_picture.gdshader")
## Over the sky and things in the room, under pointer and veils.
const PRIORITY: int = 100
## Changed controls are laid out during the frame after.
const _FRAMES: int = 2

## Size of the 2D scene, pixels.
@export var pixels := Vector2i(1280, 992):
	set(value):
		pixels = value
		viewport.size = pixels
		_fit()
## Width in the world, metres; the height follows from `pixels`.
@export_range(0.01, 10.0, 0.01, "suffix:m") var width: float = 1.92:
	set(value):
		width = value
		_fit()
## 0: not seen, 1: as drawn.
@export_range(0.0, 1.0) var opacity: float = 1.0:
	set(value):
		opacity = value
		_look.set_shader_parameter(&"opacity", opacity)

## Holds the 2D scene.
var viewport := SubViewport.new()

var _look := ShaderMaterial.new()
var _quad := QuadMesh.new()
var _to_draw: int = 0


func _init() -> void:
	viewport.disable_3d = true
	viewport.transparent_bg = true
	viewport.size = pixels
	viewport.gui_embed_subwindows = true
	viewport.render_target_update_mode = SubViewport.UPDATE_DISABLED
	add_child(viewport, false, Node.INTERNAL_MODE_BACK)
	_look.shader = SHADER
	_look.render_priority = PRIORITY
	_look.set_shader_parameter(&"picture", viewport.get_texture())
	mesh = _quad
	material_override = _look
	cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF
	gi_mode = GeometryInstance3D.GI_MODE_DISABLED
	_fit()


func _ready() -> void:
	redraw()


func _process(_delta: float) -> void:
	if _to_draw > 0 and is_visible_in_tree():
		_to_draw -= 1
		viewport.render_target_update_mode = SubViewport.UPDATE_ONCE
	if _to_draw == 0:
		set_process(false)


func _notification(what: int) -> void:
	if what == NOTIFICATION_VISIBILITY_CHANGED and is_visible_in_tree():
		redraw()


## Draws the 2D scene anew.
func redraw() -> void:
	_to_draw = _FRAMES
	set_process(true)


## Width and height in the world, metres.
func get_extent() -> Vector2:
	return _quad.size


## The pixel at a place in the model's own plane.
func to_pixel(place: Vector3) -> Vector2:
	return Vector2(place.x / _quad.size.x + 0.5, 0.5 - place.y / _quad.size.y) * Vector2(pixels)


func _fit() -> void:
	_quad.size = Vector2(width, width * pixels.y / pixels.x)
