# SPDX-License-Identifier: MIT
extends GutTest
## The scene round the hole is seen where its light arrives, as bright as it is, without seams.

const STATIC := LensingTable.MOTION_STATIC
const HOLE := Vector3(3.0, -1.0, 2.0)
const RADIUS: float = 0.5
const SIZE := Vector2i(640, 360)
## One step of an 8-bit picture.
const STEP: float = 1.0 / 255.0

var _booth: SkyBooth
var _capture: SurroundingsCapture
var _room: MeshInstance3D
var _rng := RandomNumberGenerator.new()

@warning_ignore("untyped_declaration")
func should_skip_script():
	return RendererScope.without_forward_plus()


func before_each() -> void:
	_rng.seed = 21
	_booth = SkyBooth.new()
	_booth.sky.stars_visible = false
	_booth.sky.background = BlackHoleSky.BACKGROUND_SURROUNDINGS
	_booth.sky.panorama_is_light = false
	_booth.sky.position = HOLE
	_booth.camera.cull_mask = 1
	_capture = SurroundingsCapture.new()
	_capture.resolution = 256
	_capture.msaa_3d = Viewport.MSAA_DISABLED
	_booth.sky.add_child(_capture)
	add_child(_booth)


func after_each() -> void:
	_booth.free()


func test_an_even_room_gives_an_even_picture() -> void:
	await _furnish("return vec3(0.5, 0.3, 0.1);")
	var view := _view(Vector3(0, 1, 5), 0.5)
	var picture := await _booth.take()
	var shadow := view.shadow_half_angle()
	var hole := Vec3D.to_vector3(Vec3D.scaled(view.outward(), -1.0))
	var worst := 0.0
	for i in 2000:
		var pixel := Vector2i(_rng.randi_range(0, 639), _rng.randi_range(0, 359))
		if _direction_at(view, pixel).angle_to(hole) > shadow + 0.01:
			var seen := PicturePatch.colour(picture, pixel)
			worst = maxf(worst, _largest(seen - Vector3(0.5, 0.3, 0.1)))
	gut.p("worst %.5f" % worst)
	assert_lt(worst, STEP)


func test_a_lamp_is_seen_where_its_light_arrives() -> void:
	var lamp := Vector3(-0.5, 0.3, -1.0).normalized()
	var body := "return vec3(smoothstep(0.9997, 0.9999, dot(direction, %s)));"
	await _furnish(body % ("vec3(%.6f, %.6f, %.6f)" % [lamp.x, lamp.y, lamp.z]))
	for place: Vector3 in [Vector3(0, 1, 5), Vector3(4, 0.5, 0), Vector3(0.3, -0.6, 1.6)]:
		var view := _view(place, 0.4, lamp)
		var picture := await _booth.take()
		var spot := view.star_spot(lamp, 0).pixel
		assert_true(view.holds(spot, 20.0), "in the picture")
		var light := PictureMeasure.of_image(picture)
		var sum := 0.0
		var middle := Vector2.ZERO
		for y in range(int(spot.y) - 20, int(spot.y) + 20):
			for x in range(int(spot.x) - 20, int(spot.x) + 20):
				var value := light.luminance[y * view.size.x + x]
				sum += value
				middle += value * Vector2(x + 0.5, y + 0.5)
		assert_gt(sum, 1.0, "it shines")
		var off := rad_to_deg((middle / sum).distance_to(spot) / view.focal())
		gut.p("%.4f degrees" % off)
		assert_lt(off, 0.2)


func test_there_are_no_seams() -> void:
	await _furnish("return 0.5 + 0.5 * direction;")
	_booth.sky.lensing = 0.0
	# Along an edge, and where three views meet.
	for towards: Vector3 in [Vector3(1, 0, 1), Vector3(0, 1, -1), Vector3.ONE, -Vector3.ONE]:
		var view := ExactView.new(Vector3(0, 0, 9), STATIC)
		view.size = SIZE
		view.look_along(ExactView.doubled(towards), Vector3(0.3, 0.1, 1))
		_booth.aim(view, RADIUS)
		var picture := await _booth.take()
		var worst := 0.0
		for y in range(30, 330, 10):
			for x in range(280, 360):
				var pixel := Vector2i(x, y)
				var exact := 0.5 * _direction_at(view, pixel) + 0.5 * Vector3.ONE
				worst = maxf(worst, _largest(PicturePatch.colour(picture, pixel) - exact))
		gut.p("%s: worst %.5f" % [towards, worst])
		# Half a step is what Compatibility's views round away, and the picture once more.
		assert_lt(worst, STEP if SkyBooth.is_linear() else 2.5 * STEP)


func test_rays_end_where_the_exact_solution_says() -> void:
	_booth.sky.basis = Basis.from_euler(Vector3(0.4, -0.9, 0.2))
	await _furnish("return 0.5 + 0.5 * direction;")
	var view := _view(Vector3(1, 1, 3), 0.3)
	var picture := await _booth.take()
	var worst := 0.0
	var measured := 0
	while measured < 200:
		var pixel := Vector2i(_rng.randi_range(1, 638), _rng.randi_range(1, 358))
		var exact := _ends(view, pixel)
		if exact == Vector3.ZERO:
			continue
		var seen := 2.0 * PicturePatch.colour(picture, pixel) - Vector3.ONE
		worst = maxf(worst, rad_to_deg(seen.distance_to(exact)))
		measured += 1
	gut.p("worst %.3f degrees" % worst)
	assert_lt(worst, 0.2 if SkyBooth.is_linear() else 1.2)


func test_it_follows_when_it_is_told_to() -> void:
	await _furnish("return vec3(0.2);")
	_view(Vector3(0, 1, 5), 0.5)
	_relight("return vec3(0.6);")
	await _booth.take()
	assert_almost_eq(PicturePatch.colour(await _booth.take(), Vector2i(20, 20)).x, 0.2, STEP)
	_capture.capture()
	assert_almost_eq(PicturePatch.colour(await _booth.take(), Vector2i(20, 20)).x, 0.6, STEP)
	_capture.update_mode = SurroundingsCapture.UpdateMode.ALWAYS
	await _booth.take()
	_relight("return vec3(0.4);")
	assert_almost_eq(PicturePatch.colour(await _booth.take(), Vector2i(20, 20)).x, 0.4, STEP)


func test_what_is_brighter_than_white_stays_so() -> void:
	if not SkyBooth.is_linear():
		pending("Compatibility's views end at white")
		return
	_booth.sky.exposure = -2.0
	await _furnish("return vec3(3.0, 1.0, 0.5);")
	_view(Vector3(0, 1, 5), 0.5)
	var seen := PicturePatch.colour(await _booth.take(), Vector2i(20, 20))
	assert_almost_eq(seen, Vector3(0.75, 0.25, 0.125), Vector3.ONE * STEP)


func test_the_room_itself_is_not_drawn_again_and_is_given_back() -> void:
	await _furnish("return vec3(0.4);")
	_view(Vector3(0, 1, 5), 0.5)
	_booth.sky.background = BlackHoleSky.BACKGROUND_NONE
	assert_lt(PicturePatch.colour(await _booth.take(), Vector2i(20, 20)).x, STEP)
	assert_eq(_booth.sky.surroundings, _capture.get_node(^"Views").get_texture())
	_booth.sky.remove_child(_capture)
	assert_null(_booth.sky.surroundings)
	_booth.sky.add_child(_capture)


func test_it_says_when_the_sky_would_be_captured() -> void:
	assert_eq(_capture._get_configuration_warnings().size(), 0)
	_capture.cull_mask = 3
	assert_eq(_capture._get_configuration_warnings().size(), 1)
	var alone: SurroundingsCapture = autofree(SurroundingsCapture.new())
	assert_string_contains(alone._get_configuration_warnings()[0], "child of a BlackHoleSky")


func _furnish(light: String) -> void:
	_room = TestRoom.make(light, HOLE)
	_booth.viewport.add_child(_room)
	_capture.capture()
	await _capture.captured


func _relight(light: String) -> void:
	TestRoom.relight(_room, light)


## A view of the hole, or of where a light arrives from a direction.
func _view(place: Vector3, beside: float, lamp := Vector3.ZERO) -> ExactView:
	var view := ExactView.new(place, STATIC)
	view.size = SIZE
	if lamp == Vector3.ZERO:
		view.look_beside(beside, Vector3(0.2, 1, 0))
	else:
		var exact := view.observer.star_image(place, lamp, 0)
		view.look_along(ExactView.doubled(exact["direction"]), Vector3.UP)
	_booth.aim(view, RADIUS)
	return view


func _direction_at(view: ExactView, pixel: Vector2i) -> Vector3:
	return Vec3D.to_vector3(view.to_direction(Vector2(pixel) + Vector2(0.5, 0.5)))


## Where a pixel's ray ends in the room; zero where it does not or the pixel sees much of it.
func _ends(view: ExactView, pixel: Vector2i) -> Vector3:
	var ends: Array[Vector3] = []
	for offset: Vector2i in [Vector2i.ZERO, Vector2i.RIGHT, Vector2i.DOWN]:
		var ray := view.observer.trace(view.place, _direction_at(view, pixel + offset))
		if ray["captured"]:
			return Vector3.ZERO
		ends.append(ray["sky_direction"])
	if maxf(ends[0].angle_to(ends[1]), ends[0].angle_to(ends[2])) > 0.02:
		return Vector3.ZERO
	return ends[0]


static func _largest(difference: Vector3) -> float:
	var size := difference.abs()
	return maxf(size.x, maxf(size.y, size.z))
