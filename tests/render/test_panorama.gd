# SPDX-License-Identifier: MIT
extends GutTest
## Every pixel of a lensed panorama shows the place on the sky where its ray ends.

const STATIC := LensingTable.MOTION_STATIC
const RAIN := LensingTable.MOTION_RAIN
const OBSERVERS: Array = [[STATIC, 1.3], [STATIC, 3.0], [STATIC, 30.0], [RAIN, 1.0], [RAIN, 0.3]]
const PIXELS: int = 80
## Pixels that see more of the sky than this are smeared by the filter, as they should be.
const WIDEST_FOOTPRINT: float = 0.01
const WIDTH: int = 512
const HEIGHT: int = 256

var _booth: SkyBooth
var _rng := RandomNumberGenerator.new()
var _tolerance_deg: float

@warning_ignore("untyped_declaration")
func should_skip_script():
	return RendererScope.without_forward_plus()


func before_all() -> void:
	_booth = SkyBooth.new()
	_booth.sky.stars_visible = false
	_booth.sky.panorama = _directions_as_colours()
	_booth.sky.panorama_is_light = false
	_booth.sky.background = BlackHoleSky.BACKGROUND_PANORAMA
	add_child(_booth)
	# A texel is 0.7 degrees wide. Half floats tell 0.05 degrees apart, 8 bits of sRGB 0.5.
	_tolerance_deg = 0.15 if SkyBooth.is_linear() else 1.2


func after_all() -> void:
	_booth.free()


func before_each() -> void:
	_rng.seed = 9
	_booth.sky.lensing = 1.0
	_booth.sky.basis = Basis.IDENTITY
	_booth.sky.background = BlackHoleSky.BACKGROUND_PANORAMA


func test_rays_end_where_the_exact_solution_says(p: Array = use_parameters(OBSERVERS)) -> void:
	var view := ExactView.new(_direction() * p[1], p[0])
	view.look_beside(view.shadow_half_angle() + 0.3, _direction(), _rng.randf() * TAU)
	_booth.aim(view)
	var picture: Image = await _booth.take()
	var worst := 0.0
	var measured := 0
	while measured < PIXELS:
		var pixel := Vector2i(_rng.randi_range(0, 1279), _rng.randi_range(0, 719))
		var exact := _exact(view, pixel)
		if exact == Vector3.ZERO:
			continue
		worst = maxf(worst, _off(picture, pixel, exact))
		measured += 1
	gut.p("worst of %d pixels %.3f degrees" % [measured, worst])
	assert_lt(worst, _tolerance_deg, "%s: worst direction" % [p])


func test_the_node_turns_the_panorama() -> void:
	_booth.sky.lensing = 0.0
	_booth.sky.basis = Basis.from_euler(Vector3(0.4, -0.9, 0.2))
	var view := _flat_view(Vector3(0.2, 0.5, -0.7))
	var picture: Image = await _booth.take()
	for i in 20:
		var pixel := Vector2i(_rng.randi_range(0, 1279), _rng.randi_range(0, 719))
		var exact := _booth.sky.basis.inverse() * _direction_at(view, pixel)
		assert_lt(_off(picture, pixel, exact), _tolerance_deg)


func test_no_line_where_the_panorama_closes() -> void:
	_booth.sky.lensing = 0.0
	# The left and right borders of the panorama meet at RA 6h: straight ahead.
	var view := _flat_view(Vector3(0, 0, -1))
	await _expect_all(view, Rect2i(600, 0, 80, 720), 3, _tolerance_deg)


func test_poles_are_fine() -> void:
	_booth.sky.lensing = 0.0
	for pole: Vector3 in [Vector3.UP, Vector3.DOWN]:
		var view := _flat_view(pole)
		# Nearer to a pole than half a texel there is nothing but the last row.
		await _expect_all(view, Rect2i(610, 330, 60, 60), 1, maxf(_tolerance_deg, 360.0 / WIDTH))


func test_grid_lines_lie_on_the_exact_circles() -> void:
	_booth.sky.background = BlackHoleSky.BACKGROUND_GRID
	var view := ExactView.new(Vector3(6, 1, 7), STATIC)
	view.look_beside(0.5, Vector3(0, 0.3, 1))
	_booth.aim(view)
	var picture: Image = await _booth.take()
	var crossings := 0
	for column in range(20, 1260, 20):
		var before := INF
		for row in range(10, 710):
			var sky := _exact(view, Vector2i(column, row))
			var north := sky.y if sky != Vector3.ZERO else INF
			if is_finite(before) and is_finite(north) and before * north < 0.0:
				var crossing := row - north / (north - before) + 0.5
				var line := _red_line(picture, column, row)
				assert_almost_eq(line, crossing, 0.5, "the equator in column %d" % column)
				crossings += 1
			before = north
	assert_gt(crossings, 20, "crossings of the equator measured")


## A view of the unlensed sky, with the camera there.
func _flat_view(direction: Vector3) -> ExactView:
	var view := ExactView.new(Vector3(0, 0, 50), STATIC)
	view.look_along(ExactView.doubled(direction), Vector3(0.3, 0.1, 1))
	_booth.aim(view)
	return view


func _expect_all(view: ExactView, region: Rect2i, step: int, tolerance_deg: float) -> void:
	var picture: Image = await _booth.take()
	var worst := 0.0
	for row in range(region.position.y, region.end.y, step):
		for column in range(region.position.x, region.end.x):
			var pixel := Vector2i(column, row)
			worst = maxf(worst, _off(picture, pixel, _direction_at(view, pixel)))
	gut.p("worst %.3f degrees" % worst)
	assert_lt(worst, tolerance_deg)


func _direction_at(view: ExactView, pixel: Vector2i) -> Vector3:
	return Vec3D.to_vector3(view.to_direction(Vector2(pixel) + Vector2(0.5, 0.5)))


## Where a pixel's ray ends on the sky; zero where it does not or where the pixel sees too much sky.
func _exact(view: ExactView, pixel: Vector2i) -> Vector3:
	var ends: Array[Vector3] = []
	for offset: Vector2i in [Vector2i.ZERO, Vector2i.RIGHT, Vector2i.DOWN]:
		var direction := _direction_at(view, pixel + offset)
		var ray: Dictionary = view.observer.trace(view.place, direction)
		if ray["captured"]:
			return Vector3.ZERO
		ends.append(ray["sky_direction"])
	if maxf(ends[0].angle_to(ends[1]), ends[0].angle_to(ends[2])) > WIDEST_FOOTPRINT:
		return Vector3.ZERO
	return ends[0]


## How far the direction that a pixel shows is from the exact one, degrees. A mixture of directions
## is too short a vector, and so is off as well.
func _off(picture: Image, pixel: Vector2i, exact: Vector3) -> float:
	var seen := PicturePatch.colour(picture, pixel) * 2.0 - Vector3.ONE
	return rad_to_deg(seen.distance_to(exact))


## Where in a column, near a row, the red of the equator is strongest.
func _red_line(picture: Image, column: int, near: int) -> float:
	var light := 0.0
	var moment := 0.0
	for row in range(near - 5, near + 6):
		var colour := PicturePatch.colour(picture, Vector2i(column, row))
		var red := maxf(colour.x - colour.z - 0.02, 0.0)
		light += red
		moment += red * (row + 0.5)
	return moment / light


func _direction() -> Vector3:
	return Vector3(_rng.randfn(), _rng.randfn(), _rng.randfn()).normalized()


## A panorama (u = 1/4 - RA / 360 degrees, v = (90 degrees - Dec) / 180 degrees) whose colours are
## directions: (d + 1) / 2.
func _directions_as_colours() -> ImageTexture:
	var floats := PackedFloat32Array()
	for row in HEIGHT:
		var declination := PI * (0.5 - (row + 0.5) / HEIGHT)
		for column in WIDTH:
			var right_ascension := TAU * (0.25 - (column + 0.5) / WIDTH)
			var flat := cos(declination)
			floats.append(0.5 + 0.5 * flat * cos(right_ascension))
			floats.append(0.5 + 0.5 * sin(declination))
			floats.append(0.5 - 0.5 * flat * sin(right_ascension))
	var image := Image.create_from_data(
		WIDTH, HEIGHT, false, Image.FORMAT_RGBF, floats.to_byte_array()
	)
	image.generate_mipmaps()
	return ImageTexture.create_from_image(image)
