# SPDX-License-Identifier: MIT
extends GutTest
## Through a clear sky one sees what is behind the picture where light goes straight, the bent sky
## next to the hole, and a black shadow.

## Radians of deflection between which the sky comes.
const FROM: float = PI / 6.0
const TO: float = 5.0 * PI / 12.0

var _booth: SkyBooth
var _view := ExactView.new(Vector3(1.0, 2.0, 7.5), LensingTable.MOTION_STATIC)

@warning_ignore("untyped_declaration")
func should_skip_script():
	return RendererScope.without_forward_plus()


func before_all() -> void:
	_booth = SkyBooth.new()
	_booth.viewport.transparent_bg = true
	for node in _booth.viewport.get_children():
		if node is WorldEnvironment:
			(node as WorldEnvironment).environment.background_color = Color(0.0, 0.0, 0.0, 0.0)
	add_child(_booth)


func after_all() -> void:
	_booth.free()


func before_each() -> void:
	_view = ExactView.new(Vector3(1.0, 2.0, 7.5), LensingTable.MOTION_STATIC)
	_view.size = Vector2i(640, 360)
	_view.vertical_fov_deg = 90.0
	_booth.aim(_view)
	_booth.sky.lensing = 1.0
	_booth.sky.see_through = 1.0
	_booth.sky.stars_visible = false
	_booth.sky.background = BlackHoleSky.BACKGROUND_GRID


func test_alpha_goes_with_the_deflection(
	motion: LensingTable.Motion = use_parameters(
		[LensingTable.MOTION_STATIC, LensingTable.MOTION_ORBIT]
	)
) -> void:
	_view.observer.motion = motion
	_booth.aim(_view)
	var picture := await _booth.take()
	var worst := 0.0
	var between := 0
	for y in range(4, _view.size.y, 8):
		for x in range(4, _view.size.x, 8):
			var direction := Vec3D.to_vector3(_view.to_direction(Vector2(x + 0.5, y + 0.5)))
			var expected := _share(direction)
			var off := absf(picture.get_pixel(x, y).a - expected)
			worst = maxf(worst, off)
			between += 1 if expected > 0.1 and expected < 0.9 else 0
	gut.p("%d pixels between, worst %.4f" % [between, worst])
	assert_gt(between, 50, "pixels between clear and not")
	assert_lt(worst, 0.03)


func test_the_shadow_is_black_and_the_room_is_seen_far_from_it() -> void:
	var picture := await _booth.take()
	assert_eq(picture.get_pixelv(_middle(_view.size)), Color.BLACK)
	var corner := picture.get_pixel(2, 2)
	assert_almost_eq(corner.a, 0.0, 1e-3)
	assert_almost_eq(corner.g, 0.0, 1e-3)
	_booth.sky.background = BlackHoleSky.BACKGROUND_NONE
	picture = await _booth.take()
	assert_eq(picture.get_pixelv(_middle(_view.size)), Color.BLACK, "also without a background")


func test_a_clear_sky_may_be_half_clear() -> void:
	_booth.sky.see_through = 0.5
	var picture := await _booth.take()
	assert_almost_eq(picture.get_pixel(2, 2).a, 0.5, 0.02)
	assert_eq(picture.get_pixelv(_middle(_view.size)).a, 1.0)


func test_without_the_hole_all_is_clear() -> void:
	_booth.sky.lensing = 0.0
	var picture := await _booth.take()
	for place: Vector2i in [Vector2i(2, 2), _middle(_view.size)]:
		assert_almost_eq(picture.get_pixelv(place).a, 0.0, 1e-3)


## A star that is bent little goes, its second image next to the shadow stays in part.
func test_stars_go_where_their_light_is_bent_little(
	model: BlackHoleSky.PointSpreadModel = use_parameters(
		[BlackHoleSky.PSF_GAUSSIAN, BlackHoleSky.PSF_EYE]
	)
) -> void:
	var star := ExactView.doubled(-_view.place.normalized())
	var aside := ExactView.across([1.0, 0.0, 0.0], star)
	var direction := Vec3D.to_vector3(ExactView.sum(star, 1.0, aside, 0.6))
	_booth.sky.psf_model = model
	_booth.sky.background = BlackHoleSky.BACKGROUND_NONE
	_booth.sky.stars_visible = true
	_booth.show_stars([direction.normalized()], [0.0])
	var first := _view.star_spot(direction.normalized(), 0).pixel
	var second := _view.star_spot(direction.normalized(), 1).pixel
	_booth.sky.see_through = 0.0
	var before := await _booth.take()
	_booth.sky.see_through = 1.0
	var after := await _booth.take()
	assert_gt(before.get_pixelv(first.floor()).g, 0.05)
	assert_almost_eq(after.get_pixelv(first.floor()).g, 0.0, 1e-4)
	assert_almost_eq(after.get_pixelv(first.floor()).a, 0.0, 1e-3, "a star covers nothing")
	var full := before.get_pixelv(second.floor()).g
	var kept := _share(Vec3D.to_vector3(_view.to_direction(second)))
	assert_gt(full, 0.005, "the second image")
	assert_between(kept, 0.1, 0.9, "of it")
	var left := after.get_pixelv(second.floor()).g
	if SkyBooth.is_linear():
		assert_almost_eq(left / full, kept, 0.05)
	else:
		assert_lt(left, full)
	_booth.sky.psf_model = BlackHoleSky.PSF_GAUSSIAN


func test_at_0_nothing_has_changed() -> void:
	_booth.sky.see_through = 0.0
	_booth.sky.background = BlackHoleSky.BACKGROUND_GRID
	var before := await _booth.take()
	_booth.sky.see_through = 1.0
	var clear := await _booth.take()
	_booth.sky.see_through = 0.0
	var after := await _booth.take()
	assert_ne(before.get_data(), clear.get_data())
	assert_eq(before.get_data(), after.get_data())
	assert_eq(before.get_pixel(2, 2).a, 1.0)


## How much of the sky is shown in a direction, from the exact deflection.
func _share(direction: Vector3) -> float:
	var seen := _view.observer.trace(_view.place, direction)
	if seen["captured"]:
		return 1.0
	# The observer at rest has the deflection, whoever looks.
	var resting := SkyObserver.new()
	var star: Vector3 = seen["sky_direction"]
	for order in 4:
		var image := _view.observer.star_image(_view.place, star, order)
		var seen_there: Vector3 = image["direction"]
		if seen_there.distance_to(direction) < 1e-3:
			var still := resting.star_image(_view.place, star, order)
			var orbital: float = still["orbital_angle"]
			var xi: float = still["xi"]
			return smoothstep(FROM, TO, orbital - PI + xi)
	return 1.0


func _middle(size: Vector2i) -> Vector2i:
	return Vector2i(size.x >> 1, size.y >> 1)
