# SPDX-License-Identifier: MIT
extends Node3D
## What a user adds to the scene: the sky, by script and with the addon's data. It draws, measures
## the picture and prints what is wrong, and "PASS" when nothing is.

const DATA: String = "res://addons/blackhole_sky/data/"
## So many stars are drawn for the measurement, on a circle of this share of the picture's height.
const STARS: int = 9
const CIRCLE: float = 0.4
const MOST_PIXELS: float = 0.1
const PATCH: int = 7
const WHITE_KELVIN: float = 6500.0

var _sky := BlackHoleSky.new()
var _observer := SkyObserver.new()
var _faults: PackedStringArray = []

@onready var _camera: Camera3D = $"../Camera"


func _ready() -> void:
	_sky.table = LensingTable.new()
	_expect(_sky.table.load_file(DATA + "schwarzschild.lut") == OK, "the table cannot be loaded")
	_sky.catalogue = StarCatalogue.new()
	_expect(_sky.catalogue.load_file(DATA + "hipparcos.stars") == OK, "no stars can be loaded")
	_observer.motion = LensingTable.MOTION_STATIC
	_sky.observer = _observer
	_sky.panorama = load(DATA + "milky_way.exr") as Texture2D
	_sky.background = BlackHoleSky.BACKGROUND_PANORAMA
	add_child(_sky)
	await _check_sky()
	await _check_stars()
	_expect(_sky.get_warnings().is_empty(), "warnings: %s" % _sky.get_warnings())
	for fault in _faults:
		print("FAULT: ", fault)
	print("PASS" if _faults.is_empty() else "FAIL", " ", RenderingServer.get_video_adapter_name())
	get_tree().quit(mini(_faults.size(), 1))


# The Milky Way and the catalogue: nothing in the shadow, light round it.
func _check_sky() -> void:
	var picture := await _take()
	picture.save_png("user://sky.png")
	var centre := 0.5 * Vector2(picture.get_size())
	var edge := _focal(picture) * tan(float(_observer.shadow(_camera.position)["half_angle"]))
	var dark := 0.0
	var ring := 0.0
	var around := 0.0
	for y in picture.get_height():
		for x in picture.get_width():
			var r := (Vector2(x + 0.5, y + 0.5) - centre).length()
			var light := picture.get_pixel(x, y).get_luminance()
			if r < edge - 2.0:
				dark = maxf(dark, light)
			elif r > edge + 2.0 and r < 1.5 * edge:
				ring += light
			elif r > 3.0 * edge:
				around += light
	_expect(edge > 20.0 and edge < centre.y, "the shadow's edge is at %.1f px" % edge)
	_expect(dark == 0.0, "the brightest pixel in the shadow has %.6f" % dark)
	_expect(ring > 0.0, "there is no light at the shadow's edge")
	_expect(around > 0.0, "there is no sky")


# Stars for which the exact solution says where they are seen.
func _check_stars() -> void:
	var directions: PackedVector3Array = []
	var spots: PackedVector2Array = []
	var size := Vector2(get_viewport().get_visible_rect().size)
	for i in STARS:
		var spot := 0.5 * size + Vector2.from_angle(TAU * i / STARS + 0.3) * CIRCLE * size.y
		var ray: Dictionary = _observer.trace(_camera.position, _camera.project_ray_normal(spot))
		directions.append(ray["sky_direction"])
		spots.append(spot)
	var magnitudes: PackedFloat32Array = []
	magnitudes.resize(STARS)
	var kelvins: PackedFloat32Array = []
	kelvins.resize(STARS)
	kelvins.fill(WHITE_KELVIN)
	_sky.catalogue.set_stars(directions, magnitudes, kelvins)
	_sky.background = BlackHoleSky.BACKGROUND_NONE
	_sky.exposure = -6.0
	var picture := await _take()
	picture.save_png("user://stars.png")
	for spot in spots:
		var found := _centroid(picture, spot)
		var off := found.distance_to(spot)
		_expect(off < MOST_PIXELS, "a star is %.3f px off %s" % [off, spot])


func _take() -> Image:
	for i in 4:
		await RenderingServer.frame_post_draw
	var picture := get_viewport().get_texture().get_image()
	if picture.get_format() in [Image.FORMAT_RGB8, Image.FORMAT_RGBA8]:
		picture.srgb_to_linear()
	return picture


func _focal(picture: Image) -> float:
	return 0.5 * picture.get_height() / tan(0.5 * deg_to_rad(_camera.fov))


# INF where nothing is drawn.
func _centroid(picture: Image, spot: Vector2) -> Vector2:
	var sum := 0.0
	var place := Vector2.ZERO
	for y in range(floori(spot.y) - PATCH, floori(spot.y) + PATCH + 1):
		for x in range(floori(spot.x) - PATCH, floori(spot.x) + PATCH + 1):
			var light := picture.get_pixel(x, y).get_luminance()
			sum += light
			place += light * Vector2(x + 0.5, y + 0.5)
	return place / sum if sum > 0.0 else Vector2.INF


func _expect(is_so: bool, fault: String) -> void:
	if not is_so:
		_faults.append(fault)
