# SPDX-License-Identifier: MIT
extends GutTest
## The piloted observer as scripts reach it.

const CLOSE: Vector3 = Vector3.ONE * 1e-5
const ON_THE_WAY := PilotedObserver.PROGRESS_ON_THE_WAY
const CENTRE := PilotedObserver.PROGRESS_CENTRE
const TOO_FAST := PilotedObserver.PROGRESS_TOO_FAST
const REFUSED := PilotedObserver.PROGRESS_REFUSED

var _pilot: PilotedObserver


func before_each() -> void:
	_pilot = PilotedObserver.new()


func test_without_thrust_it_falls_as_rain() -> void:
	assert_eq(_pilot.start(Vector3(0, 0, 8)), OK)
	assert_true(_pilot.is_ready())
	var rain := RadialFallPath.new()
	rain.start_with_energy(8.0, 1.0)
	for frame in 60:
		assert_eq(_pilot.advance(0.25), ON_THE_WAY)
		assert_almost_eq(_pilot.get_radius(), rain.radius_at(0.25 * (frame + 1)), 1e-9)
	assert_almost_eq(_pilot.get_position(), Vector3(0, 0, _pilot.get_radius()), CLOSE)
	assert_lt(_pilot.get_radius(), 1.0, "through the horizon")
	assert_eq(_pilot.get_celerity(), Vector3.ZERO)
	assert_eq(_pilot.get_proper_time(), 15.0)
	assert_almost_eq(_pilot.get_rain_time(), 15.0, 1e-9)
	assert_almost_eq(_pilot.get_energy(), 1.0, 1e-12)
	assert_almost_eq(_pilot.far_clock_rate(Vector3.BACK), rain.far_clock_rate_at(15.0), 1e-9)
	assert_true(is_nan(_pilot.far_clock_rate(Vector3.FORWARD)), "the shadow")
	assert_eq(_pilot.advance(100.0), CENTRE)
	assert_almost_eq(_pilot.get_radius(), 0.01, 1e-12)


func test_its_weight_as_thrust_holds_it_still() -> void:
	assert_eq(_pilot.start_static(Vector3(0, 10, 0)), OK)
	# u^2/(2 sqrt(1 - u)); Vector3 has single precision, which the unstable balance amplifies a little.
	var weight := Vector3(0, 0.005 / sqrt(0.9), 0)
	for frame in 100:
		assert_eq(_pilot.advance(0.1, weight), ON_THE_WAY)
	assert_almost_eq(_pilot.get_radius(), 10.0, 1e-6)
	assert_almost_eq(_pilot.get_rain_time(), 10.0 / sqrt(0.9), 1e-6)
	assert_almost_eq(_pilot.far_clock_rate(Vector3.RIGHT), 1.0 / sqrt(0.9), 1e-6)


func test_thrust_moves_along_the_own_axes() -> void:
	_pilot.start(Vector3(1e4, 0, 0))
	_pilot.advance(2.0, Vector3(0, 0.5, 0))
	assert_almost_eq(_pilot.get_celerity(), Vector3(0, sinh(1.0), 0), CLOSE)
	assert_almost_eq(_pilot.get_position().y, (cosh(1.0) - 1.0) / 0.5, 1e-5)


func test_time_runs_backwards_too() -> void:
	_pilot.start(Vector3(6, 0, 0), Vector3(0.3, 0, 0.4))
	assert_almost_eq(_pilot.get_angular_momentum(), Vector3(0, -2.4, 0), CLOSE)
	var energy := _pilot.get_energy()
	assert_eq(_pilot.advance(5.0), ON_THE_WAY)
	assert_almost_eq(_pilot.get_energy(), energy, 1e-10)
	assert_almost_eq(_pilot.get_angular_momentum(), Vector3(0, -2.4, 0), CLOSE)
	assert_gt(_pilot.get_position().distance_to(Vector3(6, 0, 0)), 1.0)
	assert_eq(_pilot.advance(-5.0), ON_THE_WAY)
	assert_almost_eq(_pilot.get_position(), Vector3(6, 0, 0), CLOSE)
	assert_eq(_pilot.get_proper_time(), 0.0)
	assert_almost_eq(_pilot.get_rain_time(), 0.0, 1e-9)


func test_what_is_impossible_is_refused_by_name(
	p: Array = use_parameters(
		[
			[Vector3.ZERO, Vector3.ZERO, "position"],
			[Vector3(NAN, 1, 1), Vector3.ZERO, "position"],
			[Vector3(5, 0, 0), Vector3(NAN, 0, 0), "celerity"],
			[Vector3(5, 0, 0), Vector3(2e6, 0, 0), "celerity"],
		]
	)
) -> void:
	assert_eq(_pilot.start(p[0], p[1]), ERR_INVALID_PARAMETER)
	assert_push_error(p[2])
	assert_string_contains(_pilot.get_error_message(), p[2])
	assert_false(_pilot.is_ready())
	assert_eq(_pilot.advance(1.0), REFUSED)
	assert_true(is_nan(_pilot.get_radius()))
	assert_true(is_nan(_pilot.far_clock_rate(Vector3.UP)))
	assert_eq(_pilot.get_position(), Vector3.ZERO)


func test_nothing_is_static_at_the_horizon() -> void:
	_pilot.start(Vector3(5, 0, 0))
	assert_eq(_pilot.start_static(Vector3(1, 0, 0)), ERR_INVALID_PARAMETER)
	assert_push_error("horizon")
	assert_eq(_pilot.get_radius(), 5.0, "a refused start leaves the observer")
	assert_eq(_pilot.start_static(Vector3(2, 0, 0)), OK)
	assert_eq(_pilot.get_error_message(), "")


func test_advances_end_in_reports() -> void:
	_pilot.start(Vector3(50, 0, 0))
	assert_eq(_pilot.advance(NAN), REFUSED)
	assert_eq(_pilot.advance(1.0, Vector3(INF, 0, 0)), REFUSED)
	assert_eq(_pilot.get_proper_time(), 0.0)
	assert_eq(_pilot.advance(1000.0, Vector3(0, 1, 0)), TOO_FAST)
	assert_between(_pilot.get_proper_time(), 1.0, 999.0)
