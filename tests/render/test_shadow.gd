# SPDX-License-Identifier: MIT
extends GutTest
## The shadow's edge is the exact circle, and nothing shines inside it.

const OBSERVERS: Array = [
	[LensingTable.MOTION_STATIC, 1.2],
	[LensingTable.MOTION_STATIC, 1.5],
	[LensingTable.MOTION_STATIC, 3.0],
	[LensingTable.MOTION_STATIC, 10.0],
	[LensingTable.MOTION_STATIC, 100.0],
	[LensingTable.MOTION_RAIN, 10.0],
	[LensingTable.MOTION_RAIN, 1.0],
	[LensingTable.MOTION_RAIN, 0.5],
	[LensingTable.MOTION_RAIN, 0.1],
]
const PANORAMA_LUMINANCE: float = 0.25
const AZIMUTHS: int = 96
## How far from the exact edge the picture is looked at, pixels.
const REACH: float = 4.0
const STEP: float = 0.125

var _booth: SkyBooth
var _rng := RandomNumberGenerator.new()


func before_all() -> void:
	_booth = SkyBooth.new()
	_booth.sky.panorama = _white()
	_booth.sky.panorama_luminance = PANORAMA_LUMINANCE
	_booth.sky.panorama_is_light = false
	add_child(_booth)


func after_all() -> void:
	_booth.free()


func before_each() -> void:
	_rng.seed = 7


func test_edge(p: Array = use_parameters(OBSERVERS)) -> void:
	_booth.sky.background = BlackHoleSky.BACKGROUND_PANORAMA
	_booth.sky.stars_visible = false
	var view := _view(p)
	_booth.aim(view)
	var picture: Image = await _booth.take()
	var worst := 0.0
	var mean := 0.0
	var edge := _edge(view, view.shadow_half_angle())
	var beyond := _edge(view, view.shadow_half_angle() + 1.0 / view.focal())
	var points := 0
	for i in AZIMUTHS:
		if edge[i] == ExactView.NOWHERE or not view.holds(edge[i], 10.0):
			continue
		var off := _offset(picture, edge[i], edge[i].direction_to(beyond[i]))
		worst = off if not absf(off) <= absf(worst) else worst
		mean += off
		points += 1
	mean /= points
	gut.p("%s points, worst %.4f px, mean %.4f px" % [points, worst, mean])
	assert_gte(points, 20, "%s: places of the edge measured" % [p])
	assert_almost_eq(worst, 0.0, 0.3, "%s: edge against the exact circle" % [p])
	assert_almost_eq(mean, 0.0, 0.05, "%s: radius of the shadow" % [p])


func test_nothing_shines_inside(p: Array = use_parameters(OBSERVERS)) -> void:
	_booth.sky.background = BlackHoleSky.BACKGROUND_NONE
	_booth.sky.stars_visible = true
	if _booth.sky.catalogue == null:
		_booth.sky.catalogue = StarCatalogue.new()
		_booth.sky.catalogue.load_file(SkyBooth.CATALOGUE_FILE)
	_booth.sky.psf_sigma = 0.5
	_booth.sky.magnitude_limit = 8.0
	var view := _view(p)
	view.size = Vector2i(640, 360)
	_booth.aim(view)
	var measure := PictureMeasure.of_image(await _booth.take())
	# Sprites of 0.5 px end 2.7 px from their centres.
	var limit := cos(maxf(view.shadow_half_angle() - 4.0 / view.focal(), 0.0))
	var axis := view.outward()
	var x_part := -Vec3D.dot(axis, view.right)
	var y_part := -Vec3D.dot(axis, view.up)
	var z_part := -Vec3D.dot(axis, view.forward)
	var inside := 0
	var lit_inside := 0
	var outside := 0.0
	var i := 0
	for row in view.size.y:
		var y := (0.5 * view.size.y - row - 0.5) / view.focal()
		for column in view.size.x:
			var x := (column + 0.5 - 0.5 * view.size.x) / view.focal()
			var toward := x_part * x + y_part * y + z_part
			if toward > limit * sqrt(1.0 + x * x + y * y):
				inside += 1
				lit_inside += 1 if measure.luminance[i] > 0.0 else 0
			else:
				outside += measure.luminance[i]
			i += 1
	assert_gt(inside, 40, "%s: pixels of the shadow" % [p])
	assert_eq(lit_inside, 0, "%s: pixels of the shadow with light" % [p])
	assert_gt(outside, 1.0, "%s: light outside" % [p])


## Small shadows whole, large ones with their edge in the middle.
func _view(p: Array) -> ExactView:
	var motion: LensingTable.Motion = p[0]
	var r: float = p[1]
	var view := ExactView.new(_direction() * r, motion)
	var edge := view.shadow_half_angle()
	view.look_beside(edge if edge > 0.35 else 0.3 * edge, _direction(), _rng.randf() * TAU)
	return view


## Places in the picture of the circle `xi` radians round the hole's direction.
func _edge(view: ExactView, xi: float) -> PackedVector2Array:
	var axis := view.outward()
	var side := ExactView.across(view.up, axis)
	var other := Vec3D.cross(axis, side)
	var places := PackedVector2Array()
	for i in AZIMUTHS:
		var turn := TAU * i / AZIMUTHS
		var beside := ExactView.sum(side, cos(turn), other, sin(turn))
		places.append(view.to_pixel(ExactView.sum(axis, -cos(xi), beside, sin(xi))))
	return places


## How far the dark reaches beyond the exact edge, pixels: the darkness summed along the normal.
func _offset(picture: Image, edge: Vector2, outward: Vector2) -> float:
	var patch := PicturePatch.around(picture, edge, ceili(REACH) + 3)
	var here := edge - patch.corner
	var full := patch.measure.sample(here + outward * (REACH + 1.0))
	var dark := 0.0
	var t := -REACH + 0.5 * STEP
	while t < REACH:
		dark += (1.0 - patch.measure.sample(here + outward * t) / full) * STEP
		t += STEP
	return dark - REACH


func _direction() -> Vector3:
	return Vector3(_rng.randfn(), _rng.randfn(), _rng.randfn()).normalized()


func _white() -> ImageTexture:
	var image := Image.create_empty(16, 8, false, Image.FORMAT_RGBA8)
	image.fill(Color.WHITE)
	return ImageTexture.create_from_image(image)
