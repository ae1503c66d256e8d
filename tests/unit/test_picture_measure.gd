# SPDX-License-Identifier: MIT
extends GutTest
## Measuring pictures, on pictures whose content is known.

const SIDE: int = 64
## Places within a pixel, off and on its centre and corner.
const PLACES: Array[Vector2] = [
	Vector2(32.5, 32.5), Vector2(32.0, 32.0), Vector2(31.27, 32.81), Vector2(33.9, 30.13)
]

var _sigmas: Array = [0.7, 0.8, 1.0, 1.5, 2.0, 3.0]


func test_linear_luminance_of_floats() -> void:
	var image: Image = Image.create_empty(3, 2, false, Image.FORMAT_RGBAH)
	image.set_pixel(2, 1, Color(4.0, 0.5, 0.25))
	image.set_pixel(0, 1, Color(0, 1, 0))
	var picture: PictureMeasure = PictureMeasure.of_image(image)
	assert_eq(Vector2i(picture.width, picture.height), Vector2i(3, 2))
	assert_almost_eq(picture.at(2, 1), 0.2126 * 4.0 + 0.7152 * 0.5 + 0.0722 * 0.25, 1e-6)
	assert_almost_eq(picture.at(0, 1), 0.7152, 1e-6)
	assert_eq(picture.at(1, 0), 0.0)
	assert_eq(picture.at(-1, 0), 0.0, "black outside")
	assert_eq(picture.at(3, 0), 0.0, "black outside")


func test_luminance_of_srgb_bytes() -> void:
	for format: Image.Format in [Image.FORMAT_RGB8, Image.FORMAT_RGBA8]:
		var image: Image = Image.create_empty(2, 1, false, format)
		image.set_pixel(0, 0, Color8(255, 255, 255))
		image.set_pixel(1, 0, Color8(188, 0, 10))
		var picture: PictureMeasure = PictureMeasure.of_image(image)
		assert_almost_eq(picture.at(0, 0), 1.0, 1e-6)
		# By the formula of the standard: 188 -> 0.502886, 10 -> 0.003035.
		assert_almost_eq(picture.at(1, 0), 0.2126 * 0.502886 + 0.0722 * 0.003035, 1e-5)


func test_samples_between_pixel_centres() -> void:
	var picture: PictureMeasure = PictureMeasure.of_luminance([0.0, 1.0, 2.0, 3.0], 2)
	assert_almost_eq(picture.sample(Vector2(1.5, 0.5)), 1.0, 1e-6)
	assert_almost_eq(picture.sample(Vector2(1.0, 0.5)), 0.5, 1e-6)
	assert_almost_eq(picture.sample(Vector2(1.0, 1.0)), 1.5, 1e-6)


func test_centroid_of_a_spot(sigma: float = use_parameters(_sigmas)) -> void:
	for place: Vector2 in PLACES:
		var found: Vector2 = _spot(place, sigma, 1.0, 0.0).centroid(place.round())
		assert_lt(found.distance_to(place), 0.005, "spot at %s" % place)


func test_centroid_over_a_background(sigma: float = use_parameters(_sigmas)) -> void:
	for place: Vector2 in PLACES:
		var picture: PictureMeasure = _spot(place, sigma, 0.5, 0.3)
		var found: Vector2 = picture.centroid(place + Vector2(0.8, -0.6))
		assert_lt(found.distance_to(place), 0.005, "spot at %s" % place)


func test_centroid_in_eight_bits() -> void:
	for place: Vector2 in PLACES:
		var image: Image = Image.create_empty(SIDE, SIDE, false, Image.FORMAT_RGBA8)
		var exact: PictureMeasure = _spot(place, 1.0, 0.9, 0.0)
		for y: int in SIDE:
			for x: int in SIDE:
				var light: float = exact.at(x, y)
				image.set_pixel(x, y, Color(light, light, light).linear_to_srgb())
		var found: Vector2 = PictureMeasure.of_image(image).centroid(place.round())
		assert_lt(found.distance_to(place), 0.01, "spot at %s" % place)


func test_centroid_next_to_another_spot() -> void:
	var place: Vector2 = Vector2(30.3, 32.6)
	var picture: PictureMeasure = _spot(place, 1.0, 0.5, 0.0)
	var other: PictureMeasure = _spot(place + Vector2(10.0, 0.0), 1.0, 0.5, 0.0)
	for i: int in picture.luminance.size():
		picture.luminance[i] += other.luminance[i]
	assert_lt(picture.centroid(place.round()).distance_to(place), 0.005)


func test_centroid_at_the_edge_of_the_picture() -> void:
	var place: Vector2 = Vector2(6.3, 40.8)
	assert_lt(_spot(place, 1.0, 1.0, 0.0).centroid(place.round()).distance_to(place), 0.005)


func test_no_centroid_without_light() -> void:
	var dark: PictureMeasure = _spot(Vector2(32, 32), 1.0, 0.0, 0.25)
	assert_false(dark.centroid(Vector2(32, 32)).is_finite(), "nothing but background")
	var far: PictureMeasure = _spot(Vector2(38, 32), 1.0, 1.0, 0.0)
	assert_false(far.centroid(Vector2(32, 32)).is_finite(), "the spot is elsewhere")


func test_sum_of_a_spot(sigma: float = use_parameters(_sigmas)) -> void:
	for place: Vector2 in PLACES:
		var picture: PictureMeasure = _spot(place, sigma, 1.0, 0.1)
		var background: float = picture.background_around(place, 20.0, 24.0)
		assert_almost_eq(background, 0.1, 1e-6)
		var sum: float = picture.sum_around(place, 6.0 * sigma, background)
		assert_almost_eq(sum, TAU * sigma * sigma, 1e-3 * TAU * sigma * sigma)


func test_maximum() -> void:
	var picture: PictureMeasure = _spot(Vector2(32.5, 32.5), 1.0, 0.75, 0.0)
	assert_almost_eq(picture.maximum_around(Vector2(31, 33), 3.0), 0.75, 1e-6)
	assert_lt(picture.maximum_around(Vector2(20, 20), 3.0), 1e-6)


func test_radial_profile() -> void:
	var centre: Vector2 = Vector2(31.7, 32.2)
	var profile: PackedFloat32Array = _disk(centre, 12.0, 0.0, 0.8).radial_profile(centre, 20)
	assert_eq(profile.size(), 20)
	assert_almost_eq(profile[5], 0.0, 1e-6)
	assert_almost_eq(profile[15], 0.8, 1e-6)


func test_edge_of_a_dark_disk() -> void:
	for radius: float in [6.0, 12.4, 20.7]:
		for centre: Vector2 in PLACES:
			var picture: PictureMeasure = _disk(centre, radius, 0.05, 0.8)
			var points: PackedVector2Array = picture.edge_points(
				Vector2(32, 32), radius - 5.0, radius + 5.0, 90
			)
			assert_eq(points.size(), 90)
			var fit: CircleFit = CircleFit.of_points(points)
			var where: String = "radius %s round %s" % [radius, centre]
			assert_lt(fit.centre.distance_to(centre), 0.03, where)
			# The pixels blur the edge, which draws a small circle in.
			assert_almost_eq(fit.radius, radius, 0.01 + 0.25 / radius, where)
			assert_lt(fit.largest, 0.15, where)


func test_no_edge_without_contrast() -> void:
	var flat: PictureMeasure = _disk(Vector2(32, 32), 10.0, 0.5, 0.5)
	assert_eq(flat.edge_points(Vector2(32, 32), 5.0, 15.0, 16).size(), 0)
	var cut: PictureMeasure = _disk(Vector2(2, 32), 10.0, 0.0, 0.5)
	var points: PackedVector2Array = cut.edge_points(Vector2(2, 32), 5.0, 15.0, 16)
	assert_between(points.size(), 7, 9, "half of the rays leave the picture")


func test_circle_through_points() -> void:
	var points: PackedVector2Array = []
	for i: int in 7:
		points.append(Vector2(640.25, 359.5) + 150.0 * Vector2.from_angle(0.4 * i))
	var fit: CircleFit = CircleFit.of_points(points)
	assert_almost_eq(fit.centre, Vector2(640.25, 359.5), Vector2(1e-3, 1e-3))
	assert_almost_eq(fit.radius, 150.0, 1e-3)
	assert_lt(fit.largest, 1e-3)


func test_no_circle_through_a_line() -> void:
	assert_true(is_nan(CircleFit.of_points([Vector2(0, 0), Vector2(1, 1)]).radius))
	var line: PackedVector2Array = [Vector2(0, 0), Vector2(1, 1), Vector2(2, 2), Vector2(3, 3)]
	assert_true(is_nan(CircleFit.of_points(line).radius))


func test_correlation() -> void:
	var one: PictureMeasure = _spot(Vector2(30, 30), 2.0, 1.0, 0.0)
	var brighter: PictureMeasure = _spot(Vector2(30, 30), 2.0, 3.0, 0.5)
	var moved: PictureMeasure = _spot(Vector2(50, 50), 2.0, 1.0, 0.0)
	assert_almost_eq(one.correlation(brighter), 1.0, 1e-6)
	assert_lt(one.correlation(moved), 0.05)
	var mirrored: PackedFloat32Array = [3.0, 2.0, 1.0]
	assert_almost_eq(PictureMeasure.correlation_of([1.0, 2.0, 3.0], mirrored), -1.0, 1e-9)


func test_part() -> void:
	var picture: PictureMeasure = PictureMeasure.of_luminance([0.0, 1.0, 2.0, 3.0], 2)
	var part: PictureMeasure = picture.part(Rect2i(1, 0, 2, 2))
	assert_eq(part.luminance, PackedFloat32Array([1.0, 0.0, 3.0, 0.0]))


## A Gaussian spot, sampled at pixel centres.
func _spot(place: Vector2, sigma: float, peak: float, background: float) -> PictureMeasure:
	var values: PackedFloat32Array = []
	for y: int in SIDE:
		for x: int in SIDE:
			var distance: float = place.distance_squared_to(Vector2(x + 0.5, y + 0.5))
			values.append(background + peak * exp(-distance / (2.0 * sigma * sigma)))
	return PictureMeasure.of_luminance(values, SIDE)


## A disk whose edge pixels have the mean over the pixel, to 1 / 256.
func _disk(centre: Vector2, radius: float, inside: float, outside: float) -> PictureMeasure:
	var values: PackedFloat32Array = []
	for y: int in SIDE:
		for x: int in SIDE:
			var distance: float = centre.distance_to(Vector2(x + 0.5, y + 0.5)) - radius
			var covered: float = clampf(-distance, 0.0, 1.0)
			if absf(distance) < 1.0:
				covered = _coverage(Vector2(x, y), centre, radius)
			values.append(lerpf(outside, inside, covered))
	return PictureMeasure.of_luminance(values, SIDE)


func _coverage(corner: Vector2, centre: Vector2, radius: float) -> float:
	var inside: int = 0
	for i: int in 256:
		@warning_ignore("integer_division")
		var place: Vector2 = corner + Vector2(i % 16 + 0.5, i / 16 + 0.5) / 16.0
		inside += int(centre.distance_to(place) < radius)
	return inside / 256.0
