# SPDX-License-Identifier: MIT
class_name SkyBooth
extends Node
## A viewport with a hole, a sky and a camera of its own, to take pictures of.

const TABLE_FILE: String = "res://addons/blackhole_sky/data/schwarzschild.lut"
const CATALOGUE_FILE: String = "res://addons/blackhole_sky/data/hipparcos.stars"

var viewport := SubViewport.new()
var camera := Camera3D.new()
var sky := BlackHoleSky.new()
var _warm: bool = false


func _init() -> void:
	viewport.own_world_3d = true
	# Compatibility stores display values whatever the buffer; 8 bits are what it shows.
	viewport.use_hdr_2d = is_linear()
	viewport.msaa_3d = Viewport.MSAA_DISABLED
	viewport.size = Vector2i(1280, 720)
	viewport.render_target_update_mode = SubViewport.UPDATE_DISABLED
	camera.keep_aspect = Camera3D.KEEP_HEIGHT
	sky.table = committed_table()
	sky.image_orders = 4
	sky.magnitude_limit = 99.0
	for node: Node in [dark_world(), camera, sky]:
		viewport.add_child(node)
	add_child(viewport)


## The table that comes with the project, read anew.
static func committed_table() -> LensingTable:
	var table := LensingTable.new()
	table.load_file(TABLE_FILE)
	return table


## A black world that shows luminance as it is.
static func dark_world() -> WorldEnvironment:
	var world := WorldEnvironment.new()
	world.environment = Environment.new()
	world.environment.background_mode = Environment.BG_COLOR
	world.environment.background_color = Color.BLACK
	world.environment.tonemap_mode = Environment.TONE_MAPPER_LINEAR
	return world


## True where pictures are linear light in half floats; false in Compatibility: 8 bits of sRGB.
static func is_linear() -> bool:
	return RenderingServer.get_current_rendering_method() != "gl_compatibility"


## Puts the camera where a view says and the hole's size to `radius` units.
func aim(view: ExactView, radius: float = 1.0) -> void:
	sky.schwarzschild_radius = radius
	sky.observer = view.observer
	viewport.size = view.size
	if view.vertical_fov_deg >= 1.0:
		camera.set_perspective(view.vertical_fov_deg, 0.05, 4000.0)
	else:  # narrower than the engine's perspective cameras go
		var height := 2.0 * tan(deg_to_rad(0.5 * view.vertical_fov_deg))
		camera.set_frustum(height, Vector2.ZERO, 1.0, 4000.0)
	camera.transform = view.camera_transform(radius, sky.position)


## Shows these stars and no others.
func show_stars(
	directions: PackedVector3Array, magnitudes: PackedFloat32Array, kelvins: PackedFloat32Array = []
) -> void:
	var stars := StarCatalogue.new()
	stars.set_stars(directions, magnitudes, kelvins)
	sky.catalogue = stars


## A picture of the very next frame.
func take() -> Image:
	for frame in 1 if _warm else 3:
		viewport.render_target_update_mode = SubViewport.UPDATE_ONCE
		await RenderingServer.frame_post_draw
	_warm = true
	return viewport.get_texture().get_image()
