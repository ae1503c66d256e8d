# SPDX-License-Identifier: MIT
class_name SelfTestStage
extends Node
## A viewport with a hole, a camera and a black world, a reader of shaders' answers, and the table
## and its sources that the checks use.

## A view that shows shadow, ring and the sky round it from 10 Schwarzschild radii.
const SIZE := Vector2i(512, 512)
const VERTICAL_FOV_DEG: float = 80.0
## The engine compiles its pipelines in the first frames.
const WARM_UP_FRAMES: int = 3

var sky := BlackHoleSky.new()
var camera := Camera3D.new()
var viewport := SubViewport.new()
var reader := ShaderReader.new()
## What the graphics card is given, and the numbers it must hold.
var tables: SelfTestTables


func _init() -> void:
	viewport.own_world_3d = true
	viewport.msaa_3d = Viewport.MSAA_DISABLED
	viewport.render_target_update_mode = SubViewport.UPDATE_DISABLED
	viewport.size = SIZE
	camera.keep_aspect = Camera3D.KEEP_HEIGHT
	camera.set_perspective(VERTICAL_FOV_DEG, 0.05, 4000.0)
	for node: Node in [dark_world(), camera, sky]:
		viewport.add_child(node)
	add_child(viewport)
	add_child(reader)


func _ready() -> void:
	# As in the window, so that a project without the buffer is found out. Compatibility stores
	# display values whatever the buffer.
	viewport.use_hdr_2d = is_linear() and get_tree().root.use_hdr_2d


## Gives checks and sky the same table.
func use_table(table: LensingTable) -> void:
	sky.table = table
	tables = SelfTestTables.new(table)


## A black world that shows luminance as it is.
static func dark_world() -> WorldEnvironment:
	var world := WorldEnvironment.new()
	world.environment = Environment.new()
	world.environment.background_mode = Environment.BG_COLOR
	world.environment.background_color = Color.BLACK
	world.environment.tonemap_mode = Environment.TONE_MAPPER_LINEAR
	return world


## True where pictures are linear light; false in Compatibility, which blends sRGB values.
static func is_linear() -> bool:
	return RenderingServer.get_current_rendering_method() != "gl_compatibility"


## Looks from a place (in Schwarzschild radii) to the hole.
func look_from(place: Vector3) -> void:
	camera.look_at_from_position(place, Vector3.ZERO, Vector3(0.1, 1.0, 0.2))


## Focal length in pixels.
func focal() -> float:
	return 0.5 * viewport.size.y / tan(deg_to_rad(0.5 * VERTICAL_FOV_DEG))


## Where a direction in front of the camera is seen.
func to_pixel(direction: Vector3) -> Vector2:
	var seen := direction * camera.basis
	var scale := focal() / -seen.z
	return 0.5 * Vector2(viewport.size) + Vector2(seen.x, -seen.y) * scale


## The unit vector to what is seen at a place of the picture.
func to_direction(pixel: Vector2) -> Vector3:
	var off := (pixel - 0.5 * Vector2(viewport.size)) / focal()
	return (camera.basis * Vector3(off.x, -off.y, -1.0)).normalized()


## Draws and reads the picture back.
func take() -> Image:
	for frame in WARM_UP_FRAMES:
		viewport.render_target_update_mode = SubViewport.UPDATE_ONCE
		await RenderingServer.frame_post_draw
	return viewport.get_texture().get_image()
