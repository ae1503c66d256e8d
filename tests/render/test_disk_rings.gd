# SPDX-License-Identifier: MIT
extends GutTest
## Rings of fixed r in the disk's plane are lines where the exact solution sees those radii, and
## nothing of the picture changes between them.

const RADIUS: float = 4.0
const AZIMUTHS: int = 36
## Across a line it is looked at so far, pixels.
const REACH: float = 4.0
const STEP: float = 0.125
## Of the lines' colour.
const LINE_LUMINANCE: float = 0.566

var _booth: SkyBooth
var _disk := AccretionDisk.new()
var _seen := DiskView.new(10.0, 70.0, LensingTable.MOTION_STATIC, 70.0)

@warning_ignore("untyped_declaration")
func should_skip_script():
	return RendererScope.without_forward_plus()


func before_all() -> void:
	_booth = SkyBooth.new()
	_booth.sky.stars_visible = false
	_disk.look = AccretionDisk.LOOK_RINGS
	_disk.orders = 2
	_disk.basis = _seen.disk_basis
	_booth.sky.add_child(_disk)
	add_child(_booth)
	_booth.aim(_seen.view)


func after_all() -> void:
	_booth.free()


func before_each() -> void:
	_booth.sky.background = BlackHoleSky.BACKGROUND_NONE
	_disk.ring_radii = [RADIUS]
	_disk.ring_highlight = -1
	_disk.show()


func test_a_ring_is_where_the_exact_solution_has_it() -> void:
	var measure := PictureMeasure.of_image(await _booth.take())
	for order in 2:
		var worst := 0.0
		var places := 0
		for i in AZIMUTHS:
			var place := _seen.pixel_of(RADIUS, TAU * i / AZIMUTHS, order)
			if place == ExactView.NOWHERE or not _is_alone(place, order):
				continue
			worst = maxf(worst, absf(_offset(measure, place, _across(place, order))))
			places += 1
		gut.p("order %d: %d places, worst %.3f px" % [order, places, worst])
		assert_gt(places, 8, "order %d: places measured" % order)
		assert_lt(worst, 0.7, "order %d: the line against the exact places" % order)


func test_lines_are_as_wide_as_they_are_told() -> void:
	for width: float in [1.0, 2.0, 4.0]:
		_disk.ring_width = width
		var picture := await _booth.take()
		var measure := PictureMeasure.of_image(picture)
		for i in 6:
			var place := _seen.pixel_of(RADIUS, TAU * i / 6, 0)
			if place == ExactView.NOWHERE or not _is_alone(place, 0):
				continue
			var light := 0.0
			var t := -REACH + 0.5 * STEP
			while t < REACH:
				light += measure.sample(place + _across(place, 0) * t) * STEP
				t += STEP
			assert_almost_eq(
				light / LINE_LUMINANCE, width, 0.35, "%s pixels at %s" % [width, place]
			)
	_disk.ring_width = 2.0


func test_nothing_changes_between_them() -> void:
	_booth.sky.background = BlackHoleSky.BACKGROUND_GRID
	var with_rings := await _booth.take()
	_disk.hide()
	var without := await _booth.take()
	var changed := 0
	var far := 0
	for y in range(0, with_rings.get_height(), 3):
		for x in with_rings.get_width():
			if with_rings.get_pixel(x, y) != without.get_pixel(x, y):
				changed += 1
				far += 0 if _is_near(Vector2(x + 0.5, y + 0.5)) else 1
	assert_gt(changed, 300, "pixels of the lines")
	assert_eq(far, 0, "changed pixels away from them")


func test_the_highlighted_one_is_gold() -> void:
	_disk.ring_radii = [RADIUS, 6.0]
	_disk.ring_highlight = 1
	var picture := await _booth.take()
	var blue := picture.get_pixelv(_seen.pixel_of(RADIUS, 0.5 * PI, 0).floor())
	var gold := picture.get_pixelv(_seen.pixel_of(6.0, 0.5 * PI, 0).floor())
	assert_gt(blue.b, 1.3 * blue.r, "blue-white: %s" % blue)
	assert_gt(gold.r, 2.0 * gold.b, "gold: %s" % gold)


func test_rings_may_lie_at_the_horizon_and_behind_the_eye() -> void:
	_disk.ring_radii = [1.05, 30.0]
	var measure := PictureMeasure.of_image(await _booth.take())
	for radius: float in _disk.ring_radii:
		var place := _above_the_hole(radius)
		assert_lt(absf(_offset(measure, place, Vector2.UP)), 0.7, "r = %s at %s" % [radius, place])


## How far the line's light lies from `place` along `across`, pixels.
func _offset(measure: PictureMeasure, place: Vector2, across: Vector2) -> float:
	var light := 0.0
	var moment := 0.0
	var t := -REACH + 0.5 * STEP
	while t < REACH:
		var here := measure.sample(place + across * t)
		light += here
		moment += here * t
		t += STEP
	return moment / light if light > 0.0 else INF


## Across the circle, as it is seen at a pixel.
func _across(pixel: Vector2, order: int) -> Vector2:
	var here := _seen.point_at(pixel, order).x
	var right := _seen.point_at(pixel + Vector2(0.2, 0.0), order).x
	var down := _seen.point_at(pixel + Vector2(0.0, 0.2), order).x
	return Vector2(right - here, down - here).normalized()


## Does no line of another order come near?
func _is_alone(pixel: Vector2, order: int) -> bool:
	if not _seen.view.holds(pixel, 16.0):
		return false
	var outside := _seen.point_at(pixel, 1 - order).x > RADIUS
	for turn in 12:
		var beside := pixel + Vector2.from_angle(TAU * turn / 12) * 2.0 * REACH
		if (_seen.point_at(beside, 1 - order).x > RADIUS) != outside:
			return false
	return true


## Is there a line within 3 pixels?
func _is_near(pixel: Vector2) -> bool:
	for order in 2:
		var outside := _seen.point_at(pixel, order).x > RADIUS
		for turn in 16:
			var beside := pixel + Vector2.from_angle(TAU * turn / 16) * 3.0
			if (_seen.point_at(beside, order).x > RADIUS) != outside:
				return true
	return false


## Where that radius is seen on the line upwards from the middle of the picture, which is the
## hole's.
func _above_the_hole(radius: float) -> Vector2:
	var middle := 0.5 * Vector2(_seen.view.size)
	var low := 0.1
	var high := middle.y
	var shadow := _seen.view.focal() * tan(_seen.view.shadow_half_angle())
	for i in 40:
		var half := 0.5 * (low + high)
		var seen := _seen.seen_at(middle + Vector2.UP * half, 0)
		# Next to the middle light would come from within the horizon.
		var inside: bool = seen["radius"] < radius if seen["reached"] else half < shadow
		low = half if inside else low
		high = high if inside else half
	return middle + Vector2.UP * low
