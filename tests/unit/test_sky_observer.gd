# SPDX-License-Identifier: MIT
extends GutTest
## SkyObserver: motions, where they exist, and what they see.

const PLACE := Vector3(0.0, 3.0, 4.0)

var _observer: SkyObserver
var _refused: Array = [
	# motion, properties, place, word of the reason
	[LensingTable.MOTION_STATIC, {}, Vector3(0, 0, 0.9), "horizon"],
	[LensingTable.MOTION_INFALL, {"energy": 0.5}, PLACE, "energy"],
	[LensingTable.MOTION_INFALL, {"outgoing": true}, Vector3(0, 0, 1), "outward"],
	[LensingTable.MOTION_ORBIT, {}, Vector3(1.5, 0, 0), "1.5"],
	[LensingTable.MOTION_ORBIT, {"axis": PLACE}, PLACE, "axis"],
	[
		LensingTable.MOTION_VELOCITY,
		{"relative_to_static": true},
		Vector3(0, 0.5, 0),
		"relative to rain"
	],
	[LensingTable.MOTION_RAIN, {}, Vector3.ZERO, "centre"],
]


func before_each() -> void:
	_observer = SkyObserver.new()


func test_says_why_it_does_not_exist(p: Array = use_parameters(_refused)) -> void:
	_observer.motion = p[0]
	var properties: Dictionary = p[1]
	for property: String in properties:
		_observer.set(property, properties[property])
	assert_string_contains(_observer.get_refusal(p[2]), p[3])
	assert_eq(_observer.celerity_at(p[2]), Vector3.ZERO)


func test_exists_where_it_should() -> void:
	for motion: LensingTable.Motion in [
		LensingTable.MOTION_STATIC,
		LensingTable.MOTION_RAIN,
		LensingTable.MOTION_INFALL,
		LensingTable.MOTION_ORBIT,
		LensingTable.MOTION_VELOCITY,
	]:
		_observer.motion = motion
		assert_eq(_observer.get_refusal(PLACE), "")


func test_values_that_are_none_change_nothing() -> void:
	_observer.energy = 2.0
	_observer.celerity = Vector3(1, 2, 3)
	watch_signals(_observer)
	_observer.energy = -1.0
	_observer.energy = NAN
	_observer.axis = Vector3.ZERO
	_observer.axis = Vector3(NAN, 0, 0)
	_observer.celerity = Vector3(INF, 0, 0)
	_observer.energy = 2.0
	assert_eq(_observer.energy, 2.0)
	assert_eq(_observer.axis, Vector3(0, 1, 0))
	assert_eq(_observer.celerity, Vector3(1, 2, 3))
	assert_signal_not_emitted(_observer, "changed")
	_observer.energy = 3.0
	assert_signal_emit_count(_observer, "changed", 1)


func test_velocity_and_celerity() -> void:
	var celerity := SkyObserver.celerity_from_velocity(Vector3(0.6, 0.0, 0.0))
	assert_almost_eq(celerity, Vector3(0.75, 0.0, 0.0), Vector3.ONE * 1e-6)
	assert_eq(SkyObserver.celerity_from_velocity(Vector3(0.0, 1.0, 0.0)), Vector3.ZERO)
	assert_push_error("below 1")


func test_energy_from_rest() -> void:
	assert_almost_eq(SkyObserver.energy_from_rest(4.0), sqrt(0.75), 1e-15)
	assert_true(is_nan(SkyObserver.energy_from_rest(1.0)))


## On a circular orbit the speed in the static frame is sqrt(1/(2 (r - 1))).
func test_orbit_celerity() -> void:
	_observer.motion = LensingTable.MOTION_ORBIT
	_observer.axis = Vector3(1, 0, 0)
	var celerity := _observer.celerity_at(PLACE)
	var along := Vector3(1, 0, 0).cross(PLACE).normalized()
	assert_almost_eq(celerity.dot(along), 1.0 / sqrt(2.0 * 5.0 - 3.0), 1e-6)
	assert_almost_eq(celerity.dot(PLACE.normalized()), sqrt(2.0) / sqrt(7.0), 1e-6)


## The change of an image's solid angle makes up for that of its light's frequency.
func test_mu_g_squared_is_the_same_for_all() -> void:
	var star := Vector3(0.3, -0.5, 0.2)
	var expected := 0.0
	for motion: LensingTable.Motion in [
		LensingTable.MOTION_STATIC,
		LensingTable.MOTION_RAIN,
		LensingTable.MOTION_ORBIT,
		LensingTable.MOTION_VELOCITY,
	]:
		_observer.motion = motion
		_observer.axis = Vector3(1, 0.2, 0)
		_observer.celerity = Vector3(0.4, 0.7, -2.0)
		var image := _observer.star_image(PLACE, star, 1)
		var product: float = image["magnification"] * pow(image["redshift"], 2)
		if expected == 0.0:
			expected = product
		assert_almost_eq(product / expected, 1.0, 1e-10)


func test_looking_at_an_image_finds_its_star() -> void:
	_observer.motion = LensingTable.MOTION_ORBIT
	_observer.axis = Vector3(1, 0.2, 0)
	var star := Vector3(0.3, -0.5, 0.2).normalized()
	var image := _observer.star_image(PLACE, star, 0)
	var ray := _observer.trace(PLACE, image["direction"])
	assert_false(ray["captured"])
	assert_almost_eq(ray["sky_direction"], star, Vector3.ONE * 1e-5)


func test_shadow_of_a_fast_flight_at_the_hole_shrinks() -> void:
	var still: Dictionary = _observer.shadow(PLACE)
	_observer.motion = LensingTable.MOTION_VELOCITY
	_observer.relative_to_static = true
	_observer.celerity = -PLACE.normalized() * 5.0
	var fast := _observer.shadow(PLACE)
	assert_lt(float(fast["half_angle"]), 0.2 * float(still["half_angle"]))
	assert_almost_eq(fast["direction"], -PLACE.normalized(), Vector3.ONE * 1e-5)


func test_what_does_not_exist_gives_nothing_and_an_error() -> void:
	assert_true(_observer.star_image(Vector3(0, 0, 0.5), Vector3.UP, 0).is_empty())
	assert_push_error("SkyObserver.star_image")
	assert_true(_observer.trace(Vector3(0, 0, 0.5), Vector3.UP).is_empty())
	assert_push_error("SkyObserver.trace")
	assert_true(_observer.shadow(Vector3(0, 0, 0.5)).is_empty())
	assert_push_error("SkyObserver.shadow")
