# SPDX-License-Identifier: MIT
@tool
class_name SurroundingsViews
extends SubViewport
## Draws the six views of a SurroundingsCapture and lays them out in one picture, with coarser
## copies for filtering: its own texture, as BlackHoleSky.surroundings takes it.
##
## The views are viewports below this one, and so are drawn before it.

const ATLAS: Shader = preload("res://addons/blackhole_sky/shaders/surroundings_atlas.gdshader")
## As many levels as surroundings_layout.gdshaderinc has.
const LEVELS: int = 6
## In the order of the faces: where a view looks and where its top is, in the sky's axes.
const AHEAD: PackedVector3Array = [
	Vector3.RIGHT, Vector3.LEFT, Vector3.UP, Vector3.DOWN, Vector3.BACK, Vector3.FORWARD
]
const TOP: PackedVector3Array = [
	Vector3.UP, Vector3.UP, Vector3.BACK, Vector3.FORWARD, Vector3.UP, Vector3.UP
]

## Side of the sheet that the layout is drawn on, at least as large as any: one of another size
## would be drawn only a frame later. The shader counts on it.
const SHEET: float = 16384.0

var _views: Array[SubViewport] = []
var _cameras: Array[Camera3D] = []
var _sheet := ColorRect.new()
var _material := ShaderMaterial.new()


func _init() -> void:
	disable_3d = true
	_be_quiet(self)
	_material.shader = ATLAS
	_sheet.material = _material
	_sheet.size = Vector2.ONE * SHEET
	add_child(_sheet)
	for face in AHEAD.size():
		var view := SubViewport.new()
		_be_quiet(view)
		var camera := Camera3D.new()
		view.add_child(camera)
		add_child(view)
		camera.make_current()
		_views.append(view)
		_cameras.append(camera)
		_material.set_shader_parameter("_view_%d" % face, view.get_texture())


## Draws all of them for the next picture, or for every one.
func draw(always: bool) -> void:
	var mode := SubViewport.UPDATE_ALWAYS if always else SubViewport.UPDATE_ONCE
	for view in _views:
		view.render_target_update_mode = mode
	render_target_update_mode = mode


## Stops drawing for every picture.
func rest() -> void:
	for viewport: SubViewport in [self] + _views:
		if viewport.render_target_update_mode == SubViewport.UPDATE_ALWAYS:
			viewport.render_target_update_mode = SubViewport.UPDATE_DISABLED


## Takes the views from a place, along axes (without scale).
func place(at: Transform3D) -> void:
	for face in _cameras.size():
		var turned := Basis.looking_at(AHEAD[face], TOP[face])
		_cameras[face].global_transform = at * Transform3D(turned, Vector3.ZERO)
		_cameras[face].force_update_transform()  # for the picture that is about to be drawn


## Gives each face so many pixels a side, besides its border of one, and its views their depth.
func set_lens(pixels: int, near: float, far: float) -> void:
	for face in _views.size():
		_views[face].size = Vector2i.ONE * (pixels + 2)
		_cameras[face].set_perspective(rad_to_deg(2.0 * atan((pixels + 2.0) / pixels)), near, far)
	size = _layout_size(pixels)
	_material.set_shader_parameter("_size", pixels)


## What is seen, and how smooth its edges are.
func set_look(cull_mask: int, world: Environment, smoothing: Viewport.MSAA) -> void:
	for face in _views.size():
		_views[face].msaa_3d = smoothing
		_cameras[face].cull_mask = cull_mask
		_cameras[face].environment = world


# The levels beside the first one lie below each other.
static func _layout_size(pixels: int) -> Vector2i:
	var width := 3 * (pixels + 2) + 3 * ((pixels >> 1) + 2)
	var beside := 0
	for level in range(1, LEVELS):
		beside += 2 * ((pixels >> level) + 2)
	return Vector2i(width, maxi(2 * (pixels + 2), beside))


static func _be_quiet(viewport: SubViewport) -> void:
	viewport.render_target_update_mode = SubViewport.UPDATE_DISABLED
	viewport.gui_disable_input = true
	viewport.handle_input_locally = false
	# Compatibility stores display values whatever the buffer; 8 bits are what it shows.
	var linear := RenderingServer.get_current_rendering_method() != "gl_compatibility"
	viewport.use_hdr_2d = linear
