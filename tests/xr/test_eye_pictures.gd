# SPDX-License-Identifier: MIT
extends XrTestCase
## Each eye sees the stars from its own place: their images stand in both pictures where the exact
## solution puts them for that eye, and nowhere else.

const TOLERANCE_PX: float = 0.15
const STARS: int = 150
## Images nearer to each other, in pixels, disturb each other's measurement.
const APART: float = 13.0

var _directions: PackedVector3Array = []


class Spot:
	extends RefCounted
	var star: int
	var order: int
	var pixel: Vector2
	var light: float


func test_stars_in_both_eyes(p: Array = use_parameters([[0.3, 8.0], [0.5, 5.5]])) -> void:
	if not await begun():
		return
	var pictures := await _take(p[0], p[1])
	if pictures.size() < 2:
		return
	var eyes := eyes_of(pictures)
	for view in 2:
		var spots := _alone(eyes[view], eyes[view].place)
		var worst := 0.0
		var lensed := 0
		for spot in spots:
			var off := PicturePatch.centroid(pictures[view], spot.pixel).distance_to(spot.pixel)
			worst = off if not off <= worst else worst
			lensed += 1 if spot.order > 0 else 0
		gut.p("eye %d: %d images, %d lensed, worst %.3f px" % [view, spots.size(), lensed, worst])
		assert_gte(spots.size(), 7, "images measured")
		assert_lt(worst, TOLERANCE_PX, "worst place")
		# The test sees whose place it is: from the other eye's they would stand elsewhere.
		assert_gt(_shift(eyes[view], eyes[1 - view].place, spots), 4.0 * TOLERANCE_PX, "other eye")
		var middle := 0.5 * (eyes[0].place + eyes[1].place)
		assert_gt(_shift(eyes[view], middle, spots), 2.0 * TOLERANCE_PX, "middle of the head")


## Pictures with a hole of this radius (metres), so many radii away.
func _take(radius: float, distance: float) -> Array[Image]:
	show_sky_alone()
	var sky := visit.scene.sky
	sky.background = BlackHoleSky.BACKGROUND_NONE
	sky.stereo_baseline_scale = 1.0
	sky.exposure = 0.0
	sky.magnitude_limit = 99.0
	sky.psf_model = BlackHoleSky.PSF_GAUSSIAN
	var rng := RandomNumberGenerator.new()
	rng.seed = 5
	_directions.clear()
	var magnitudes: PackedFloat32Array = []
	var temperatures: PackedFloat32Array = []
	for i in STARS:
		_directions.append(Vector3(rng.randfn(), rng.randfn(), rng.randfn()).normalized())
		magnitudes.append(0.4)
		temperatures.append(6500.0)
	var catalogue := StarCatalogue.new()
	catalogue.set_stars(_directions, magnitudes, temperatures)
	sky.catalogue = catalogue
	var eyes := Vector3(0.2, 1.5, 0.3)
	await move_head(Transform3D(Basis(Vector3.UP, 0.12), eyes))
	sky.schwarzschild_radius = radius
	sky.global_position = eyes + Vector3(-0.1, 0.1, -1.0).normalized() * radius * distance
	return await take_pictures()


## Images of stars that stand alone in an eye's picture, seen from `place`.
func _alone(eye: EyeView, place: Vector3) -> Array[Spot]:
	var all: Array[Spot] = []
	for i in _directions.size():
		for order in 2:
			all.append(_spot(eye, place, i, order))
	var chosen: Array[Spot] = []
	for spot in all:
		if spot.light > 0.3 and spot.light < 3.0 and eye.holds(spot.pixel, 14.0):
			if not all.any(_disturbs.bind(spot)):
				chosen.append(spot)
	return chosen


func _spot(eye: EyeView, place: Vector3, star: int, order: int) -> Spot:
	var sky := visit.scene.sky
	var from_hole := (place - sky.global_position) / sky.schwarzschild_radius
	var observer := SkyObserver.new()
	observer.motion = LensingTable.MOTION_STATIC
	var image := observer.star_image(from_hole, _directions[star], order)
	var spot := Spot.new()
	spot.star = star
	spot.order = order
	spot.pixel = eye.to_pixel(image["direction"])
	spot.light = image["magnification"]
	return spot


func _disturbs(other: Spot, spot: Spot) -> bool:
	var same := other.star == spot.star and other.order == spot.order
	return (
		not same and other.light > 1e-3 * spot.light and other.pixel.distance_to(spot.pixel) < APART
	)


## How far, in the mean, these images would be moved by seeing them from `place`.
func _shift(eye: EyeView, place: Vector3, spots: Array[Spot]) -> float:
	var sum := 0.0
	for spot in spots:
		sum += _spot(eye, place, spot.star, spot.order).pixel.distance_to(spot.pixel)
	return sum / maxf(spots.size(), 1.0)
