# SPDX-License-Identifier: MIT
extends GutTest
## Maps of the whole sky: stars stand where the map's formula puts them, also behind the camera,
## near the poles and on the seam, with the light that the pixels' solid angle asks for.

const SIZE := Vector2i(1024, 640)
const PLACE := Vector3(2.0, 1.5, -6.0)
const KELVIN: float = 6500.0
const STARS: int = 16
const TOLERANCE_PX: float = 0.2
## Luminance summed over each image, and pixels between images.
const LIGHT: float = 2.0
const APART: float = 20.0

var _booth: SkyBooth
var _view: ExactView
var _rng := RandomNumberGenerator.new()
var _directions: PackedVector3Array
var _magnitudes: PackedFloat32Array
var _kelvins: PackedFloat32Array
var _pixels: PackedVector2Array
var _spots: PackedVector2Array
var _projections: Array = [
	BlackHoleSky.PROJECTION_EQUIRECTANGULAR,
	BlackHoleSky.PROJECTION_MERCATOR,
	BlackHoleSky.PROJECTION_MOLLWEIDE,
	BlackHoleSky.PROJECTION_FISHEYE_180,
	BlackHoleSky.PROJECTION_FISHEYE_220,
	BlackHoleSky.PROJECTION_FISHEYE_360,
]


## A place of a map and its area per solid angle, in units of the map's middle.
class MapPoint:
	extends RefCounted
	var place: Vector2
	var density: float


@warning_ignore("untyped_declaration")
func should_skip_script():
	return RendererScope.mobile_alone()


func before_all() -> void:
	_booth = SkyBooth.new()
	add_child(_booth)


func after_all() -> void:
	_booth.free()


func before_each() -> void:
	_rng.seed = 5
	_view = ExactView.new(PLACE, LensingTable.MOTION_ORBIT)
	_view.observer.axis = Vector3(0.2, 1.0, 0.1)
	_view.size = SIZE
	_view.look_along([0.3, -0.1, 0.9], Vector3(0.1, 1.0, 0.0))
	_booth.sky.image_orders = 2
	_directions = []
	_magnitudes = []
	_kelvins = []
	_pixels = []
	_spots = []


func test_places_and_light(map: BlackHoleSky.Projection = use_parameters(_projections)) -> void:
	_booth.sky.projection = map
	for attempt in 4000:
		if _pixels.size() < STARS:
			_try_star(map, Vector3(_rng.randfn(), _rng.randfn(), _rng.randfn()).normalized())
	assert_eq(_pixels.size(), STARS)
	_booth.show_stars(_directions, _magnitudes, _kelvins)
	_booth.aim(_view)
	var picture: Image = await _booth.take()
	var worst := 0.0
	var worst_light := 0.0
	for pixel in _pixels:
		var off := PicturePatch.centroid(picture, pixel).distance_to(pixel)
		worst = off if not off <= worst else worst
		if SkyBooth.is_linear():
			var light := PicturePatch.light(picture, pixel, 6)
			worst_light = maxf(worst_light, absf(light / LIGHT - 1.0))
	gut.p("worst %.3f px, light %.2f %%" % [worst, 100.0 * worst_light])
	assert_lt(worst, TOLERANCE_PX)
	assert_lt(worst_light, 0.03)


## A star right behind the camera: half of its light on either side of the map.
func test_sprites_on_the_seam_are_drawn_on_both_sides(
	map: BlackHoleSky.Projection = use_parameters(
		[
			BlackHoleSky.PROJECTION_EQUIRECTANGULAR,
			BlackHoleSky.PROJECTION_MERCATOR,
			BlackHoleSky.PROJECTION_MOLLWEIDE,
		]
	)
) -> void:
	_booth.sky.projection = map
	_booth.sky.lensing = 0.0
	_view.look_along([0, 0, -1], Vector3.UP)
	_booth.show_stars([Vector3(-1e-4, 0.0, 1.0)], [2.0], [KELVIN])
	_booth.aim(_view)
	var picture: Image = await _booth.take()
	_booth.sky.lensing = 1.0
	var half := _extent(map).x * _scale(map)
	var left := PicturePatch.light(picture, Vector2(SIZE) * 0.5 - Vector2(half - 3.0, 0.5), 6)
	var right := PicturePatch.light(picture, Vector2(SIZE) * 0.5 + Vector2(half - 3.0, -0.5), 6)
	assert_almost_eq(left / right, 1.0, 0.1)
	if SkyBooth.is_linear():
		var whole := (
			pow(10.0, -0.8)
			* ExactView.STAR_GAIN
			* pow(_scale(map) / ExactView.REFERENCE_FOCAL_PX, 2)
		)
		assert_almost_eq((left + right) / whole, 1.0, 0.05)


func test_outside_of_the_map_is_black(
	map: BlackHoleSky.Projection = use_parameters(_projections)
) -> void:
	_booth.sky.projection = map
	_booth.sky.background = BlackHoleSky.BACKGROUND_GRID
	_booth.sky.lensing = 0.0
	_booth.aim(_view)
	var picture: Image = await _booth.take()
	_booth.sky.background = BlackHoleSky.BACKGROUND_NONE
	_booth.sky.lensing = 1.0
	var inside := 0
	for y in range(0, SIZE.y, 16):
		for x in range(0, SIZE.x, 16):
			var part := (
				(Vector2(x, y) + Vector2(0.5, 0.5) - Vector2(SIZE) * 0.5)
				/ (_extent(map) * _scale(map))
			)
			var beyond := (
				part.length()
				if map >= BlackHoleSky.PROJECTION_MOLLWEIDE
				else maxf(absf(part.x), absf(part.y))
			)
			var light := picture.get_pixel(x, y).get_luminance()
			if beyond > 1.01:
				assert_eq(light, 0.0, "%s" % Vector2i(x, y))
			elif beyond < 0.98:
				inside += 1
				if light <= 0.0:
					assert_gt(light, 0.0, "%s" % Vector2i(x, y))
	assert_gt(inside, 100)


func after_each() -> void:
	_booth.sky.projection = BlackHoleSky.PROJECTION_PERSPECTIVE


## Chooses a star whose image, of order 0 and 1 in turns, stands alone on the map.
func _try_star(map: BlackHoleSky.Projection, star: Vector3) -> void:
	var wanted := _pixels.size() % 2
	var image := _view.observer.star_image(PLACE, star, wanted)
	var other := _view.observer.star_image(PLACE, star, 1 - wanted)
	var point := _map_point(map, _in_view(image["direction"]))
	var beside := _map_point(map, _in_view(other["direction"]))
	if point == null:
		return
	var pixel := _to_pixel(map, point)
	var spot := Vector2(INF, INF) if beside == null else _to_pixel(map, beside)
	if not Rect2(Vector2.ZERO, SIZE).grow(-12.0).has_point(pixel):
		return
	if spot.distance_to(pixel) < APART:
		return
	for taken in _spots:
		if taken.distance_to(pixel) < APART or taken.distance_to(spot) < APART:
			return
	var g: float = image["redshift"]
	var mu: float = image["magnification"]
	var light := (
		ExactView.STAR_GAIN
		* pow(_scale(map) / ExactView.REFERENCE_FOCAL_PX, 2)
		* point.density
		* mu
		* PlanckLight.shift_factor(KELVIN / g, g)
	)
	_spots.append_array([pixel, spot])
	_directions.append(star)
	_magnitudes.append(2.5 * log(light / LIGHT) / log(10.0))
	_kelvins.append(KELVIN / g)
	_pixels.append(pixel)


func _to_pixel(map: BlackHoleSky.Projection, point: MapPoint) -> Vector2:
	return Vector2(SIZE) * 0.5 + point.place * Vector2(1, -1) * _scale(map)


## A world direction in the camera's axes: right, up, forward.
func _in_view(direction: Vector3) -> PackedFloat64Array:
	var d := Vec3D.normalized(ExactView.doubled(direction))
	return [Vec3D.dot(d, _view.right), Vec3D.dot(d, _view.up), Vec3D.dot(d, _view.forward)]


func _extent(map: BlackHoleSky.Projection) -> Vector2:
	match map:
		BlackHoleSky.PROJECTION_EQUIRECTANGULAR:
			return Vector2(PI, PI / 2.0)
		BlackHoleSky.PROJECTION_MERCATOR:
			return Vector2(PI, PI)
		BlackHoleSky.PROJECTION_MOLLWEIDE:
			return Vector2(2.0 * sqrt(2.0), sqrt(2.0))
		BlackHoleSky.PROJECTION_FISHEYE_180:
			return Vector2.ONE * deg_to_rad(90.0)
		BlackHoleSky.PROJECTION_FISHEYE_220:
			return Vector2.ONE * deg_to_rad(110.0)
	return Vector2.ONE * PI


## Pixels per unit of the map.
func _scale(map: BlackHoleSky.Projection) -> float:
	var fit := Vector2(SIZE) * 0.5 / _extent(map)
	return minf(fit.x, fit.y)


## Where the textbooks put a direction; null where the map does not show it.
func _map_point(map: BlackHoleSky.Projection, d: PackedFloat64Array) -> MapPoint:
	var point := MapPoint.new()
	var longitude := atan2(d[0], d[2])
	var latitude := asin(clampf(d[1], -1.0, 1.0))
	match map:
		BlackHoleSky.PROJECTION_EQUIRECTANGULAR:
			point.place = Vector2(longitude, latitude)
			point.density = 1.0 / cos(latitude)
		BlackHoleSky.PROJECTION_MERCATOR:
			point.place = Vector2(longitude, log(tan(PI / 4.0 + latitude / 2.0)))
			point.density = 1.0 / pow(cos(latitude), 2)
			if absf(point.place.y) > PI:
				return null
		BlackHoleSky.PROJECTION_MOLLWEIDE:
			var low := -PI / 2.0
			var high := PI / 2.0
			for step in 60:
				var middle := 0.5 * (low + high)
				if 2.0 * middle + sin(2.0 * middle) < PI * sin(latitude):
					low = middle
				else:
					high = middle
			point.place = Vector2(2.0 * sqrt(2.0) / PI * longitude * cos(low), sqrt(2.0) * sin(low))
			point.density = 1.0
		_:
			var angle := acos(clampf(d[2], -1.0, 1.0))
			if angle > _extent(map).x:
				return null
			point.place = Vector2(d[0], d[1]).normalized() * angle
			point.density = angle / sin(angle)
	return point
