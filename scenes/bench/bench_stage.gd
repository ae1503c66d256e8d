# SPDX-License-Identifier: MIT
class_name BenchStage
extends Node
## The pictures whose drawing is timed, in a viewport of their own, from one place in one direction.

enum Picture {
	EMPTY,
	PLAIN_STARS,
	LENSED_STARS_1,
	LENSED_STARS_2,
	PLAIN_PANORAMA,
	LENSED_PANORAMA,
	HIDDEN_DISK,
	DISK,
	MARCH_1000,
}

const SIZE := Vector2i(1280, 720)
const TABLE_FILE: String = "res://addons/blackhole_sky/data/schwarzschild.lut"
const CATALOGUE_FILE: String = "res://addons/blackhole_sky/data/hipparcos.stars"
const MARCH_SHADER: Shader = preload("res://scenes/bench/march.gdshader")
## Fainter than every star of the catalogue: all of it is drawn.
const MAGNITUDE_LIMIT: float = 15.0
## Distance of the eye from the hole, in its Schwarzschild radii, and the direction to it.
const DISTANCE: float = 10.0
const OUTWARD := Vector3(0.36, 0.48, 0.8)

var viewport := SubViewport.new()
var sky := BlackHoleSky.new()
var camera := Camera3D.new()

var _march := MeshInstance3D.new()
## Three orders of a black-body disk.
var _disk := AccretionDisk.new()


func _init() -> void:
	viewport.size = SIZE
	viewport.own_world_3d = true
	viewport.use_hdr_2d = true
	viewport.render_target_update_mode = SubViewport.UPDATE_ALWAYS
	camera.keep_aspect = Camera3D.KEEP_HEIGHT
	camera.fov = 60.0
	var world := WorldEnvironment.new()
	world.environment = Environment.new()
	world.environment.background_mode = Environment.BG_COLOR
	world.environment.background_color = Color.BLACK
	for node: Node in [world, camera, sky, _march]:
		viewport.add_child(node)
	_disk.basis = Basis(Vector3.RIGHT, 0.5)
	_disk.visible = false
	add_child(viewport)
	aim(0.0)


## Gives the sky its table and stars, and `panorama` as background. Returns what is missing, or
## nothing.
func dress(panorama: Texture2D, luminance: float) -> String:
	var table := LensingTable.new()
	if table.load_file(TABLE_FILE) != OK:
		return table.get_error_message()
	var catalogue := StarCatalogue.new()
	if catalogue.load_file(CATALOGUE_FILE) != OK:
		return catalogue.get_error_message()
	sky.table = table
	sky.catalogue = catalogue
	sky.magnitude_limit = MAGNITUDE_LIMIT
	sky.panorama = panorama
	sky.panorama_luminance = luminance
	_march.mesh = _screen_triangle()
	_march.custom_aabb = AABB(Vector3.ONE * -1e6, Vector3.ONE * 2e6)
	_march.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF
	var material := ShaderMaterial.new()
	material.shader = MARCH_SHADER
	material.set_shader_parameter("_panorama", panorama)
	material.set_shader_parameter("_panorama_luminance", luminance)
	material.set_shader_parameter("_planck_table", BlackBody.get_texture())
	material.set_shader_parameter("_hole_position", Vector3.ZERO)
	material.set_shader_parameter("_inverse_radius", 1.0 / sky.schwarzschild_radius)
	_march.material_override = material
	show_picture(Picture.EMPTY)
	return ""


## Turns the eye by `angle` (radians) round the hole, which stays a little off the picture's middle.
func aim(angle: float) -> void:
	var place := (OUTWARD * DISTANCE).rotated(Vector3.UP, angle)
	camera.transform = Transform3D(Basis.IDENTITY, place).looking_at(Vector3(0.4, 0.3, 0.0))


func show_picture(picture: Picture) -> void:
	var stars := [Picture.PLAIN_STARS, Picture.LENSED_STARS_1, Picture.LENSED_STARS_2]
	var with_disk := picture == Picture.DISK or picture == Picture.HIDDEN_DISK
	var panoramas := [
		Picture.PLAIN_PANORAMA, Picture.LENSED_PANORAMA, Picture.HIDDEN_DISK, Picture.DISK
	]
	var plain := picture == Picture.PLAIN_STARS or picture == Picture.PLAIN_PANORAMA
	sky.visible = picture != Picture.EMPTY and picture != Picture.MARCH_1000
	sky.stars_visible = stars.has(picture)
	sky.background = (
		BlackHoleSky.BACKGROUND_PANORAMA if panoramas.has(picture) else BlackHoleSky.BACKGROUND_NONE
	)
	sky.image_orders = 2 if picture == Picture.LENSED_STARS_2 else 1
	sky.lensing = 0.0 if plain else 1.0
	_march.visible = picture == Picture.MARCH_1000
	if with_disk and _disk.get_parent() == null:
		sky.add_child(_disk)
	elif not with_disk and _disk.get_parent() != null:
		sky.remove_child(_disk)
	_disk.visible = picture == Picture.DISK


func _notification(what: int) -> void:
	if what == NOTIFICATION_PREDELETE and _disk.get_parent() == null:
		_disk.free()


func _screen_triangle() -> ArrayMesh:
	var arrays := []
	arrays.resize(Mesh.ARRAY_MAX)
	arrays[Mesh.ARRAY_VERTEX] = PackedVector3Array(
		[Vector3(-1, -1, 0), Vector3(3, -1, 0), Vector3(-1, 3, 0)]
	)
	var mesh := ArrayMesh.new()
	mesh.add_surface_from_arrays(Mesh.PRIMITIVE_TRIANGLES, arrays)
	return mesh
