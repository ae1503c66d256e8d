# SPDX-License-Identifier: MIT
extends GutTest
## Every number that the tour's texts quote, in English and in German, is the one that the exact
## solution gives.

const FILE: String = "res://scenes/tour/black_hole_tour.tres"
const GERMAN: String = "res://scenes/tour/locale/de.po"
const NUMBER: String = "[0-9]+(?:[.,][0-9]+)?"
## Of the Moon as it is seen from Earth, degrees; of the Sun, kilometres (IAU 2015).
const MOON_WIDTH: float = 0.52
const SUN_RADIUS: float = 695700.0
const GALACTIC_CENTRE_MASS: float = 4.3e6
const STATIC := LensingTable.MOTION_STATIC
const RAIN := LensingTable.MOTION_RAIN

var _tour: Tour
var _sky: BlackHoleSky


func before_all() -> void:
	_tour = TourFile.read(FILE).tour


func before_each() -> void:
	_sky = BlackHoleSky.new()
	add_child_autofree(_sky)


func _station(id: StringName) -> TourStation:
	for station in _tour.stations:
		if station.id == id:
			return station
	return null


func _numbers_in(text: String) -> PackedStringArray:
	var numbers := PackedStringArray()
	for hit in RegEx.create_from_string(NUMBER).search_all(text):
		numbers.append(hit.get_string().replace(",", "."))
	return numbers


func _assert_numbers(id: StringName, expected: PackedStringArray) -> void:
	var german := load(GERMAN) as Translation
	var quoted := PackedStringArray()
	var quoted_in_german := PackedStringArray()
	for caption in _station(id).captions:
		assert_eq(_numbers_in(caption.headset_text).size(), 0, caption.headset_text)
		quoted.append_array(_numbers_in(caption.text))
		quoted_in_german.append_array(_numbers_in(german.get_message(caption.text)))
	assert_eq(quoted, expected, "%s in English" % id)
	assert_eq(quoted_in_german, expected, "%s in German" % id)


func _assert_says(id: StringName, words: String) -> void:
	var all := " ".join(_station(id).captions.map(func(c: TourCaption) -> String: return c.text))
	assert_string_contains(all, words)


func _shadow(radius: float, motion: LensingTable.Motion = STATIC) -> float:
	return rad_to_deg(LensingTable.shadow_angle(radius, motion))


# Angle from the hole at which light arrives that has swept so many half turns, radians.
func _ring(radius: float, half_turns: int) -> float:
	var star := Vector3(1e-6, 0.0, -1.0 if half_turns % 2 == 1 else 1.0)
	var xi: float = (
		LensingTable
		. star_image(Vector3(0.0, 0.0, radius), star.normalized(), half_turns - 1, STATIC)["xi"]
	)
	return xi


# Of light whose nearest distance is so many Schwarzschild radii, degrees.
func _deflection(nearest: float) -> float:
	var far := 1e5
	var impact := nearest / sqrt(1.0 - 1.0 / nearest)
	var xi := asin(impact / far * sqrt(1.0 - 1.0 / far))
	var ray := Vector3(sin(xi), 0.0, -cos(xi))
	var end: Vector3 = LensingTable.trace(Vector3(0.0, 0.0, far), ray, STATIC)["sky_direction"]
	return rad_to_deg(ray.angle_to(end))


func _is_number(number: float, digits: int) -> String:
	return "%.*f" % [digits, number]


func test_every_station_is_tested_here() -> void:
	var tested: Array[StringName] = [
		&"far_away", &"weak_lensing", &"einstein_ring", &"image_orders", &"photon_sphere"
	]
	tested.append_array([&"shadow_sizes", &"fall", &"looking_back", &"disk", &"not_shown"])
	for station in _tour.stations:
		assert_has(tested, station.id)


func test_far_away() -> void:
	var radius := _station(&"far_away").radius
	_sky.mass_solar = 10.0
	var ten_suns := _sky.get_length_unit_km()
	_sky.mass_solar = GALACTIC_CENTRE_MASS
	var centre := _sky.get_length_unit_km() / 1e6
	var numbers := [_is_number(radius, 0), _is_number(_shadow(radius), 0)]
	numbers.append_array([_is_number(ten_suns, 0), _is_number(centre, 1)])
	_assert_numbers(&"far_away", PackedStringArray(numbers))
	assert_eq(roundi(_shadow(radius) / MOON_WIDTH), 6)
	_assert_says(&"far_away", "six times as wide as the full Moon")


func test_weak_lensing() -> void:
	_sky.mass_solar = 1.0
	var at_the_sun := rad_to_deg(2.0 * _sky.get_length_unit_km() / SUN_RADIUS)
	var bent := _is_number(_deflection(20.0), 0)
	_assert_numbers(&"weak_lensing", PackedStringArray(["20", bent, _is_number(at_the_sun, 4)]))


func test_einstein_ring() -> void:
	var station := _station(&"einstein_ring")
	var ring := rad_to_deg(2.0 * _ring(station.radius, 1))
	var shadow := _shadow(station.radius)
	var numbers := [_is_number(station.radius, 0), _is_number(ring, 1), _is_number(shadow, 1)]
	_assert_numbers(&"einstein_ring", PackedStringArray(numbers))
	assert_almost_eq(station.behind, StartView.GALACTIC_CENTRE, Vector2.ONE * 1e-3)


func test_image_orders() -> void:
	var radius := _station(&"image_orders").radius
	var edge := 0.5 * LensingTable.shadow_angle(radius, STATIC)
	var thinner := (_ring(radius, 3) - edge) / (_ring(radius, 4) - edge)
	_assert_numbers(&"image_orders", PackedStringArray([_is_number(thinner, 0)]))
	# The eye is aimed at the edge.
	assert_almost_eq(_station(&"image_orders").look_offset.x, rad_to_deg(edge), 0.05)


func test_photon_sphere() -> void:
	var radius := _station(&"photon_sphere").radius
	var up: float = LensingTable.trace(Vector3(0.0, 0.0, radius), Vector3.BACK, STATIC)["redshift"]
	var numbers := [_is_number(radius, 1), _is_number(_shadow(radius), 0), _is_number(up, 2)]
	_assert_numbers(&"photon_sphere", PackedStringArray(numbers))


func test_shadow_sizes() -> void:
	var from_afar := 1e4 * sin(deg_to_rad(0.5 * _shadow(1e4)))
	var straight := rad_to_deg(2.0 * asin(1.0 / 10.0))
	var numbers := [_is_number(from_afar, 1), "10", _is_number(_shadow(10.0), 1)]
	numbers.append_array([_is_number(straight, 1), "3", _is_number(_shadow(3.0), 0)])
	numbers.append_array(["2.5", _is_number(_shadow(2.5), 0)])
	_assert_numbers(&"shadow_sizes", PackedStringArray(numbers))
	var station := _station(&"shadow_sizes")
	for i in 4:
		var there: float = [10.0, 10.0, 3.0, 2.5][i]
		assert_almost_eq(station.get_radius_at(i), there, 1e-6)
	var orbit := CircularOrbitPath.new()
	orbit.start(Vector3(2.99, 0.0, 0.0), Vector3.UP)
	assert_false(orbit.is_stable())
	orbit.start(Vector3(3.01, 0.0, 0.0), Vector3.UP)
	assert_true(orbit.is_stable())


func test_the_fall() -> void:
	var radius := _station(&"fall").radius
	_sky.mass_solar = GALACTIC_CENTRE_MASS
	var second := _sky.get_time_unit_seconds()
	var fall := RadialFallPath.new()
	fall.start_from_rest(radius)
	var to_horizon := fall.proper_time_to(1.0)
	var observer := SkyObserver.new()
	observer.motion = LensingTable.MOTION_INFALL
	observer.energy = fall.get_energy()
	var half: float = observer.shadow(Vector3(0.0, 0.0, 1.0))["half_angle"]
	var numbers := [_is_number(radius, 0), _is_number(to_horizon * second / 60.0, 0)]
	numbers.append(_is_number(floorf(rad_to_deg(2.0 * half)), 0))
	numbers.append(_is_number((fall.get_duration() - to_horizon) * second, 0))
	_assert_numbers(&"fall", PackedStringArray(numbers))


func test_looking_back() -> void:
	var fall := RadialFallPath.new()
	fall.start_with_energy(2.0, 1.0)
	assert_almost_eq(fall.far_clock_rate_at(fall.proper_time_to(1.0)), 0.5, 1e-6)
	_assert_says(&"looking_back", "half its frequency")
	var horizon := 0.5 * LensingTable.shadow_angle(1.0, RAIN) + 1e-5
	var beside := Vector3(sin(horizon), 0.0, -cos(horizon))
	var shift: float = LensingTable.trace(Vector3(0.0, 0.0, 1.0), beside, RAIN)["redshift"]
	var numbers := [_is_number(shift, 1), "0.5", _is_number(_shadow(0.5, RAIN), 0)]
	_assert_numbers(&"looking_back", PackedStringArray(numbers))
	var sky_share := 0.5 * (1.0 + cos(0.5 * LensingTable.shadow_angle(0.5, RAIN)))
	assert_almost_eq(sky_share, 0.8, 0.005)
	_assert_says(&"looking_back", "Four fifths")


func test_the_disk() -> void:
	_assert_numbers(&"disk", PackedStringArray())
	var inner := Vector3(3.0, 0.0, 0.0)
	var gas := SkyObserver.new()
	gas.motion = LensingTable.MOTION_ORBIT
	assert_almost_eq(ObserverSpeed.of(gas.celerity_at(inner), inner), 0.5, 1e-5)
	_assert_says(&"disk", "half the speed of light")
	# Seen from before it, the normal up: on the left it comes nearer.
	var eye := Vector3(0.0, 2.0, 20.0)
	var still := SkyObserver.new()
	var left := still.disk_point(eye, Vector3(-0.4, -0.1, -1.0).normalized(), Vector3.UP, 0)
	var right := still.disk_point(eye, Vector3(0.4, -0.1, -1.0).normalized(), Vector3.UP, 0)
	var from_left: float = left["redshift"]
	var from_right: float = right["redshift"]
	assert_gt(from_left, 1.0)
	assert_lt(from_right, 1.0)


func test_tides_of_ten_suns_are_deadly() -> void:
	_assert_numbers(&"not_shown", PackedStringArray())
	_sky.mass_solar = 10.0
	# Along a body of two metres, at a hundred radii: c^2 / r_s^2 times 2 m / r^3.
	var per_metre := _sky.get_acceleration_unit_g() / (_sky.get_length_unit_km() * 1e3)
	assert_gt(per_metre * 2.0 / pow(100.0, 3.0), 10.0)
