# SPDX-License-Identifier: MIT
extends GutTest
## Lines over the sky stand where the exact solution puts them: rings, edge and direction of motion,
## and what lies on the celestial sphere, as the hole bends it.

const PLACE := Vector3(1.2, 2.0, -3.6)

var _booth: SkyBooth
var _view: ExactView

@warning_ignore("untyped_declaration")
func should_skip_script():
	return RendererScope.mobile_alone()


func before_all() -> void:
	_booth = SkyBooth.new()
	_booth.sky.stars_visible = false
	_booth.sky.overlay_width = 2.0
	add_child(_booth)


func after_all() -> void:
	_booth.free()


func before_each() -> void:
	_view = ExactView.new(PLACE, LensingTable.MOTION_STATIC)
	_view.vertical_fov_deg = 100.0
	_booth.sky.overlays = 0
	_booth.sky.figure_field = null


func test_nothing_is_drawn_unasked() -> void:
	var picture := await _picture()
	for pixel: Vector2 in [Vector2(640, 360), Vector2(100, 100)]:
		assert_eq(_light(picture, pixel), 0.0)


func test_shadow_edge() -> void:
	await _check_circle(BlackHoleSky.OVERLAY_SHADOW_EDGE, _view.shadow_half_angle())


## The first Einstein ring is what lies straight behind the hole, the second what lies behind the
## eye.
func test_einstein_rings() -> void:
	var behind := _view.observer.star_image(PLACE, -PLACE, 0)
	await _check_circle(BlackHoleSky.OVERLAY_EINSTEIN_RINGS, behind["xi"])
	var before := _view.observer.star_image(PLACE, PLACE, 1)
	await _check_circle(BlackHoleSky.OVERLAY_EINSTEIN_RINGS, before["xi"])


func test_straight_light_is_dashed() -> void:
	_booth.sky.overlays = BlackHoleSky.OVERLAY_STRAIGHT_LIGHT
	var picture := await _picture()
	var radius := _view.focal() * tan(asin(1.5 / PLACE.length()))
	var lit := 0
	for i in 360:
		var at := Vector2(640, 360) + Vector2.from_angle(deg_to_rad(i)) * radius
		lit += 1 if _light(picture, at) > 0.03 else 0
	assert_between(lit, 140, 260)


## There the quantity whose levels are drawn goes to infinity, within a pixel.
func test_nothing_is_drawn_opposite_the_hole() -> void:
	_booth.sky.overlays = (
		BlackHoleSky.OVERLAY_SHADOW_EDGE
		| BlackHoleSky.OVERLAY_EINSTEIN_RINGS
		| BlackHoleSky.OVERLAY_STRAIGHT_LIGHT
	)
	_booth.sky.projection = BlackHoleSky.PROJECTION_FISHEYE_360
	var picture := await _picture()
	_booth.sky.projection = BlackHoleSky.PROJECTION_PERSPECTIVE
	var edge := 360.0 * _view.shadow_half_angle() / PI
	var at_edge := 0.0
	var at_outline := 0.0
	for i in 720:
		var way := Vector2.from_angle(deg_to_rad(0.5 * i))
		at_edge = maxf(at_edge, _light(picture, Vector2(640, 360) + way * edge))
		for off: float in [0.6, 1.2, 2.0]:
			at_outline = maxf(at_outline, _light(picture, Vector2(640, 360) + way * (360.0 - off)))
	assert_gt(at_edge, 0.1, "the shadow's edge")
	assert_eq(at_outline, 0.0, "the outline is the point opposite")


func test_direction_of_motion() -> void:
	_view.observer.motion = LensingTable.MOTION_VELOCITY
	_view.observer.relative_to_static = true
	_view.observer.celerity = Vector3(0.3, -0.2, 0.5)
	# The moving observer's axes are turned a little against the static one's.
	_view.look_along(ExactView.doubled(_apex()), Vector3.UP)
	_booth.sky.overlays = BlackHoleSky.OVERLAY_MOTION
	var picture := await _picture()
	assert_gt(_light(picture, Vector2(640, 360)), 0.1, "the dot")
	assert_eq(_light(picture, Vector2(640, 369)), 0.0, "between dot and circle")
	assert_gt(_light(picture, Vector2(640 + 18, 360)), 0.1, "the circle")


func test_a_figure_is_bent_as_stars_are() -> void:
	var one := Vector3(-0.5, -0.3, 0.7).normalized()
	var two := Vector3(-0.1, -0.6, 0.9).normalized()
	var faces := FigureField.bake([one, two], 512)
	_booth.sky.figure_field = Cubemap.new()
	assert_eq(_booth.sky.figure_field.create_from_images(faces), OK)
	_booth.sky.overlays = BlackHoleSky.OVERLAY_CONSTELLATIONS
	var picture := await _picture()
	var measured := 0
	for i in range(1, 20):
		var star := one.slerp(two, i / 20.0)
		var spot := _view.star_spot(star, 0).pixel
		if spot == ExactView.NOWHERE or not _view.holds(spot, 10.0):
			continue
		measured += 1
		assert_gt(_light(picture, spot), 0.04, "%s at %s" % [i, spot])
		var next := _view.star_spot(one.slerp(two, (i + 0.2) / 20.0), 0).pixel
		var aside := spot.direction_to(next).orthogonal()
		for side: float in [-4.0, 4.0]:
			assert_lt(_light(picture, spot + aside * side), 0.02)
	assert_gt(measured, 10)


func test_grids_pass_through_their_points() -> void:
	_booth.sky.lensing = 0.0
	_view.look_along([0.8, 0.55, -0.2], Vector3.UP)
	_booth.sky.overlays = BlackHoleSky.OVERLAY_EQUATORIAL_GRID
	var picture := await _picture()
	for p: Array in [[30.0, 37.0], [45.0, 22.0], [22.0, 30.0]]:
		var pixel := _view.to_pixel(ExactView.doubled(SkyAxes.direction(p[0], p[1])))
		assert_gt(_light(picture, pixel), 0.015, "%s" % [p])
	var between := _view.to_pixel(ExactView.doubled(SkyAxes.direction(22.0, 37.0)))
	assert_eq(_light(picture, between), 0.0)
	# Galactic pole and centre (ICRS): the lines through them.
	_booth.sky.overlays = BlackHoleSky.OVERLAY_GALACTIC_GRID
	var centre := SkyAxes.direction(266.405, -28.936)
	_view.look_along(ExactView.doubled(centre), Vector3.UP)
	picture = await _picture()
	assert_gt(_light(picture, Vector2(640, 360)), 0.05)
	_booth.sky.lensing = 1.0


## Where the observer goes to, in its own axes: the boost of the direction in the static frame.
func _apex() -> Vector3:
	var resting := SkyObserver.new().celerity_at(PLACE)
	var own := _view.observer.celerity_at(PLACE)
	var gamma := sqrt(1.0 + own.length_squared())
	var away := (
		own * (sqrt(1.0 + resting.length_squared()) - resting.dot(own) / (1.0 + gamma)) - resting
	)
	return away.normalized()


func _check_circle(overlay: BlackHoleSky.Overlay, xi: float) -> void:
	_booth.sky.overlays = overlay
	var picture := await _picture()
	var radius := _view.focal() * tan(xi)
	for i in 12:
		var towards := Vector2.from_angle(TAU * i / 12.0)
		var middle := Vector2(640, 360)
		assert_gt(_light(picture, middle + towards * radius), 0.1, "%d" % i)
		assert_lt(_light(picture, middle + towards * (radius + 5.0)), 0.05, "%d outside" % i)


func _picture() -> Image:
	_booth.aim(_view)
	return await _booth.take()


func _light(picture: Image, at: Vector2) -> float:
	return PicturePatch.sample(picture, at)
