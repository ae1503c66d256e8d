# SPDX-License-Identifier: MIT
extends GutTest
## Observers are chosen where they exist, refused by name where not, and turn into others in time.

const UP: Vector3 = Vector3.UP

var _sky: BlackHoleSky
var _choice: ObserverChoice

var _impossible: Array = (
	ParameterFactory
	. named_parameters(
		["kind", "radius", "energy", "word"],
		[
			[ObserverKind.Kind.STATIC, 1.0, 1.0, "hover"],
			[ObserverKind.Kind.STATIC, 0.4, 1.0, "hover"],
			[ObserverKind.Kind.DROPPED, 1.0, 1.0, "at rest"],
			[ObserverKind.Kind.FALLING, 12.0, 0.5, "1.333"],
			[ObserverKind.Kind.RISING, 12.0, 0.5, "1.333"],
			[ObserverKind.Kind.RISING, 0.9, 1.2, "outward"],
			[ObserverKind.Kind.RISING, 0.9, 0.5, "outward"],
			[ObserverKind.Kind.ORBIT_RIGHT, 1.5, 1.0, "1.5"],
			[ObserverKind.Kind.ORBIT_LEFT, 0.7, 1.0, "1.5"],
		]
	)
)


func before_all() -> void:
	TranslationServer.set_locale("en")


func before_each() -> void:
	_sky = BlackHoleSky.new()
	_sky.table = SkyBooth.committed_table()
	_choice = ObserverChoice.new()
	_choice.sky = _sky
	add_child_autofree(_sky)
	add_child_autofree(_choice)
	watch_signals(_choice)


func _at(radius: float) -> Vector3:
	return Vector3(0.0, 0.0, radius)


func _last_notice() -> String:
	var parameters: Array = get_signal_parameters(_choice, "warned")
	return parameters[1]


func test_every_kind_exists_far_out() -> void:
	for kind: ObserverKind.Kind in ObserverKind.Kind.values():
		assert_true(_choice.choose(kind, _at(10.0), UP))
		assert_eq(_choice.get_kind(), kind)
		assert_eq(_sky.observer_motion, ObserverChoice.MOTIONS[kind])
		assert_eq(_sky.get_observer_refusal_at(_at(10.0)), "")
	assert_signal_not_emitted(_choice, "warned")


func test_the_impossible_is_refused_by_name(p: Variant = use_parameters(_impossible)) -> void:
	var radius: float = p.radius
	_sky.observer_motion = LensingTable.MOTION_RAIN
	_choice.energy = p.energy
	assert_false(_choice.choose(p.kind, _at(radius), UP))
	assert_eq(_sky.observer_motion, LensingTable.MOTION_RAIN)
	assert_string_contains(_last_notice(), p.word)


func test_a_single_key_goes_through_what_exists() -> void:
	var seen: Array[int] = []
	for i in 4:
		_choice.choose_next(_at(2.0), UP)
		seen.append(_choice.get_kind())
	assert_eq(
		seen,
		[
			ObserverKind.Kind.RAIN,
			ObserverKind.Kind.DROPPED,
			ObserverKind.Kind.ORBIT_RIGHT,
			ObserverKind.Kind.STATIC
		]
	)
	seen.clear()
	for i in 3:
		_choice.choose_next(_at(1.2), UP)
		seen.append(_choice.get_kind())
	assert_eq(
		seen,
		[ObserverKind.Kind.RAIN, ObserverKind.Kind.DROPPED, ObserverKind.Kind.STATIC],
		"no orbit inside 1.5"
	)
	assert_signal_not_emitted(_choice, "warned")
	_sky.observer_motion = LensingTable.MOTION_RAIN
	_choice.choose_next(_at(0.9), UP)
	assert_eq(_choice.get_kind(), ObserverKind.Kind.RAIN)
	assert_signal_emit_count(_choice, "warned", 1)


func test_who_is_dropped_is_at_rest_there() -> void:
	_choice.choose(ObserverKind.Kind.DROPPED, _at(4.0), UP)
	var speed := ObserverSpeed.of(_sky.observer.celerity_at(_at(4.0)), _at(4.0))
	assert_almost_eq(speed, 0.0, 1e-3)
	# Energy sqrt(3/4): at r = 2 the static observer measures gamma = sqrt(3/4) / sqrt(1/2).
	speed = ObserverSpeed.of(_sky.observer.celerity_at(_at(2.0)), _at(2.0))
	assert_almost_eq(speed, sqrt(1.0 - 1.0 / 1.5), 1e-5)


func test_orbits_go_to_the_right_and_to_the_left_of_the_picture() -> void:
	# Seen from +z with y up, right is +x.
	_choice.choose(ObserverKind.Kind.ORBIT_RIGHT, _at(6.0), UP)
	assert_gt(_sky.observer.celerity_at(_at(6.0)).x, 0.1)
	_choice.choose(ObserverKind.Kind.ORBIT_LEFT, _at(6.0), UP)
	assert_lt(_sky.observer.celerity_at(_at(6.0)).x, -0.1)


func test_a_static_observer_at_the_horizon_turns_to_rain_once() -> void:
	_choice.watch(_at(1.5))
	assert_eq(_sky.observer_motion, LensingTable.MOTION_STATIC)
	_choice.watch(_at(1.0))
	_choice.watch(_at(0.9))
	assert_eq(_sky.observer_motion, LensingTable.MOTION_RAIN)
	assert_signal_emit_count(_choice, "warned", 1)


func test_an_orbiter_who_comes_too_near_turns_to_rain() -> void:
	_choice.choose(ObserverKind.Kind.ORBIT_RIGHT, _at(3.0), UP)
	_choice.watch(_at(1.4))
	assert_eq(_choice.get_kind(), ObserverKind.Kind.RAIN)
	assert_string_contains(_last_notice(), "1.5")


func test_who_was_dropped_hovers_above_the_turning_point() -> void:
	_choice.choose(ObserverKind.Kind.DROPPED, _at(3.0), UP)
	_choice.watch(_at(2.5))
	assert_eq(_choice.get_kind(), ObserverKind.Kind.DROPPED)
	_choice.watch(_at(3.5))
	assert_eq(_choice.get_kind(), ObserverKind.Kind.STATIC)
	assert_string_contains(_last_notice(), "hover")


func test_a_lighter_hole_has_a_smaller_horizon() -> void:
	_sky.lensing = 0.2
	_choice.watch(_at(0.3))
	assert_eq(_sky.observer_motion, LensingTable.MOTION_STATIC)
	_sky.lensing = 0.0
	_choice.watch(_at(0.1))
	assert_eq(
		_sky.observer_motion, LensingTable.MOTION_STATIC, "without a hole one stands anywhere"
	)


func test_rests_during_a_ride_and_resumes() -> void:
	_choice.choose(ObserverKind.Kind.ORBIT_LEFT, _at(5.0), UP)
	_choice.resting = true
	_sky.observer = SkyObserver.new()
	_choice.watch(_at(0.5))
	assert_eq(_choice.get_kind(), ObserverKind.Kind.ORBIT_LEFT)
	assert_signal_not_emitted(_choice, "warned")
	_choice.resume(_at(4.0))
	assert_eq(_sky.observer_motion, LensingTable.MOTION_ORBIT)
	assert_eq(_sky.observer.axis, -UP)
	_choice.resting = true
	_choice.resume(_at(0.5))
	assert_eq(_choice.get_kind(), ObserverKind.Kind.RAIN)
	assert_signal_emit_count(_choice, "warned", 1)


func test_who_was_dropped_is_the_same_after_a_flight_without_the_hole() -> void:
	_choice.choose(ObserverKind.Kind.DROPPED, _at(3.0), UP)
	var energy := _sky.observer.energy
	_choice.resting = true
	_sky.observer = SkyObserver.new()
	_sky.lensing = 0.0
	_choice.resume(_at(2.0))
	assert_eq(_choice.get_kind(), ObserverKind.Kind.DROPPED)
	assert_eq(_sky.observer.energy, energy)
