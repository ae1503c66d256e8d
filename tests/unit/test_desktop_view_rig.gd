# SPDX-License-Identifier: MIT
extends GutTest
## The eye's motion round the hole: exact flows, no poles, no way into the centre.

const EPS: float = 2e-5

var _rig: ViewRig
var _nonsense: Array = ParameterFactory.named_parameters(
	["value"], [[NAN], [INF], [-INF], [0.0], [1e-30]]
)


func before_each() -> void:
	_rig = ViewRig.new()
	_rig.look_from(Vector3(0.0, 0.0, 10.0), Vector3.UP)


func _forward() -> Vector3:
	return _rig.get_orientation() * Vector3.FORWARD


func _assert_near(got: Vector3, expected: Vector3, within: float, text: String = "") -> void:
	assert_lt(got.distance_to(expected), within, "%s: got %s, expected %s" % [text, got, expected])


func _assert_sound(text: String) -> void:
	assert_true(_rig.get_position().is_finite(), text + ": position is finite")
	assert_true(_rig.get_orientation().is_finite(), text + ": orientation is finite")
	assert_almost_eq(_rig.get_orientation().length(), 1.0, 1e-5, text + ": a rotation")
	var within := ViewRig.FARTHEST * 1.00001
	assert_between(_rig.get_distance(), ViewRig.NEAREST * 0.99999, within, text)


func test_orbit_to_the_right_moves_the_eye_to_its_right() -> void:
	_rig.orbit(PI / 2.0, 0.0)
	_assert_near(_rig.get_position(), Vector3(10.0, 0.0, 0.0), 1e-4)
	_assert_near(_forward(), Vector3.LEFT, EPS, "still looks at the hole")


func test_orbit_upwards_moves_the_eye_up() -> void:
	_rig.orbit(0.0, PI / 2.0)
	_assert_near(_rig.get_position(), Vector3(0.0, 10.0, 0.0), 1e-4)
	_assert_near(_forward(), Vector3.DOWN, EPS, "still looks at the hole")


func test_orbit_over_both_poles_comes_back_smoothly() -> void:
	var steps := 360
	for i in steps:
		var up_before := _rig.get_orientation() * Vector3.UP
		_rig.orbit(0.0, TAU / steps)
		var turned := up_before.angle_to(_rig.get_orientation() * Vector3.UP)
		assert_lt(turned, 1.5 * TAU / steps, "no jump at step %d" % i)
	_assert_sound("after a turn")
	_assert_near(_rig.get_position(), Vector3(0.0, 0.0, 10.0), 1e-3, "back at the start")
	_assert_near(_forward(), Vector3.FORWARD, 1e-4, "back at the start")


func test_orbit_keeps_the_distance() -> void:
	for i in 500:
		_rig.orbit(0.13, -0.07)
	assert_almost_eq(_rig.get_distance(), 10.0, 1e-4)
	_assert_near(_forward(), -_rig.get_position().normalized(), 1e-4, "looks at the hole")


func test_approach_multiplies_the_distance() -> void:
	_rig.approach(log(4.0))
	assert_almost_eq(_rig.get_distance(), 2.5, EPS)
	_rig.approach(-log(8.0))
	assert_almost_eq(_rig.get_distance(), 20.0, 1e-4)


func test_flight_straight_at_the_hole_divides_the_distance() -> void:
	_rig.fly(Vector3.FORWARD * log(5.0))
	_assert_near(_rig.get_position(), Vector3(0.0, 0.0, 2.0), EPS)


func test_flight_straight_away_multiplies_the_distance() -> void:
	_rig.fly(Vector3.BACK * log(5.0))
	_assert_near(_rig.get_position(), Vector3(0.0, 0.0, 50.0), 1e-4)


func test_flight_does_not_depend_on_the_steps() -> void:
	var way := Vector3(0.9, 0.4, -1.7)
	var once := ViewRig.new()
	once.look_from(Vector3(3.0, 4.0, 5.0), Vector3.UP)
	var many := ViewRig.new()
	many.look_from(Vector3(3.0, 4.0, 5.0), Vector3.UP)
	once.fly(way)
	for i in 50:
		many.fly(way / 50.0)
	_assert_near(many.get_position(), once.get_position(), 1e-4 * once.get_distance())


func test_speed_of_flight_is_the_distance() -> void:
	_rig.fly(Vector3(1e-3, 0.0, 0.0))
	_assert_near(_rig.get_position(), Vector3(0.01, 0.0, 10.0), 1e-4)


func test_flight_past_the_centre_stays_sound() -> void:
	_rig.turn(1e-4, 0.0, 0.0)
	for i in 400:
		_rig.fly(Vector3.FORWARD * 0.05)
		_assert_sound("step %d" % i)


func test_from_a_thousand_to_a_twentieth_and_back() -> void:
	_rig.look_from(Vector3(600.0, 0.0, 800.0), Vector3.UP)
	var seconds := log(1000.0 / 0.05) / ViewControls.FLIGHT_SPEED
	var frames := ceili(seconds * 60.0)
	for i in frames:
		_rig.fly(Vector3.FORWARD * (log(1000.0 / 0.05) / frames))
	assert_almost_eq(_rig.get_distance(), 0.05, 1e-3)
	assert_lt(seconds, 20.0, "in a time that a visitor waits")
	for i in frames:
		_rig.approach(-log(1000.0 / 0.05) / frames)
	assert_almost_eq(_rig.get_distance(), 1000.0, 20.0)


func test_limits() -> void:
	for i in 30:
		_rig.fly(Vector3.FORWARD)
	assert_almost_eq(_rig.get_distance(), ViewRig.NEAREST, 1e-6, "nearest by flight")
	for i in 30:
		_rig.fly(Vector3.BACK)
	assert_almost_eq(_rig.get_distance(), ViewRig.FARTHEST, 1e-2, "farthest by flight")
	for i in 30:
		_rig.approach(1.0)
	assert_almost_eq(_rig.get_distance(), ViewRig.NEAREST, 1e-6, "nearest by approach")
	_rig.fly(Vector3(1e9, 0.0, 0.0))
	_assert_sound("a flight beyond measure")


func test_centre_is_no_place() -> void:
	_rig.place(Vector3.ZERO, Quaternion.IDENTITY)
	assert_almost_eq(_rig.get_distance(), ViewRig.NEAREST, 1e-6)
	_assert_sound("placed at the centre")
	_rig.look_from(Vector3(0.0, 1e-20, 0.0), Vector3.UP)
	_assert_sound("placed next to the centre")


func test_nonsense_changes_nothing(p: Variant = use_parameters(_nonsense)) -> void:
	var value: float = p.value
	_rig.orbit(value, value)
	_rig.turn(value, value, value)
	_rig.approach(value)
	_rig.fly(Vector3(value, value, value))
	_rig.place(Vector3(value, 0.0, 10.0), Quaternion(0.0, 0.0, 0.0, 0.0))
	_assert_sound("value %s" % value)
	_assert_near(_rig.get_position(), Vector3(0.0, 0.0, 10.0), 1e-5)
	_assert_near(_forward(), Vector3.FORWARD, 1e-5)


func test_transform_is_in_metres() -> void:
	var transform := _rig.get_transform(3.0)
	_assert_near(transform.origin, Vector3(0.0, 0.0, 30.0), 1e-4)
