# SPDX-License-Identifier: MIT
extends GutTest
## Circular orbits as scripts reach them.

const CLOSE: Vector3 = Vector3.ONE * 1e-5

var _orbit: CircularOrbitPath


func before_each() -> void:
	_orbit = CircularOrbitPath.new()


func test_an_orbit_goes_round() -> void:
	assert_eq(_orbit.start(Vector3(10, 0, 0), Vector3(0, 3, 0)), OK)
	assert_true(_orbit.is_ready())
	assert_eq(_orbit.get_radius(), 10.0)
	assert_eq(_orbit.get_axis(), Vector3.UP)
	var period := _orbit.get_period()
	assert_almost_eq(_orbit.position_at(0.0), Vector3(10, 0, 0), CLOSE)
	assert_almost_eq(_orbit.position_at(0.25 * period), Vector3(0, 0, -10), CLOSE)
	assert_almost_eq(_orbit.position_at(-0.25 * period), Vector3(0, 0, 10), CLOSE)
	assert_almost_eq(_orbit.position_at(period), Vector3(10, 0, 0), CLOSE)
	# Kepler's third law with M = 1/2, and the orbit's time dilation
	assert_almost_eq(_orbit.get_rain_period(), TAU * sqrt(2000.0), 1e-9)
	assert_almost_eq(period, _orbit.get_rain_period() * sqrt(1.0 - 0.15), 1e-9)
	assert_almost_eq(_orbit.rain_time_at(period), _orbit.get_rain_period(), 1e-9)
	assert_almost_eq(_orbit.get_energy(), 0.9 / sqrt(0.85), 1e-14)


func test_celerity_is_relative_to_rain() -> void:
	_orbit.start(Vector3(4, 0, 0), Vector3.UP)
	# sqrt(2u/(2 - 3u)) outward, sqrt(u/(2 - 3u)) along the orbit
	assert_almost_eq(_orbit.celerity_at(0.0), Vector3(sqrt(0.4), 0, -sqrt(0.2)), CLOSE)


func test_far_clocks_are_seen_fast_ahead_of_the_motion() -> void:
	_orbit.start(Vector3(10, 0, 0), Vector3.UP)
	var ahead := _orbit.far_clock_rate_at(0.0, Vector3.FORWARD)
	var behind := _orbit.far_clock_rate_at(0.0, Vector3.BACK)
	assert_gt(ahead, 1.0)
	assert_lt(behind, ahead)
	# Aberration moves the hole from straight inward towards the motion.
	assert_true(is_nan(_orbit.far_clock_rate_at(0.0, Vector3(-1, 0, -0.24))), "the shadow")
	assert_false(is_nan(_orbit.far_clock_rate_at(0.0, Vector3(-1, 0, 0.24))), "beside it")


func test_stability(
	p: Array = use_parameters([[1.6, false], [2.99, false], [3.0, true], [50.0, true]])
) -> void:
	_orbit.start(Vector3(0, 0, p[0]), Vector3.UP)
	assert_eq(_orbit.is_stable(), p[1])


func test_what_is_impossible_is_refused_by_name(
	p: Array = use_parameters(
		[
			[Vector3(1.5, 0, 0), Vector3.UP, "1.5"],
			[Vector3.ZERO, Vector3.UP, "1.5"],
			[Vector3(5, 0, 0), Vector3.RIGHT, "axis"],
			[Vector3(5, 0, 0), Vector3.ZERO, "axis"],
			[Vector3(NAN, 0, 0), Vector3.UP, "1.5"],
		]
	)
) -> void:
	assert_eq(_orbit.start(p[0], p[1]), ERR_INVALID_PARAMETER)
	assert_push_error(p[2])
	assert_string_contains(_orbit.get_error_message(), p[2])
	assert_false(_orbit.is_ready())
	assert_false(_orbit.is_stable())
	assert_true(is_nan(_orbit.get_period()))
	assert_eq(_orbit.position_at(1.0), Vector3.ZERO)


func test_a_refused_start_leaves_the_orbit() -> void:
	_orbit.start(Vector3(5, 0, 0), Vector3.UP)
	_orbit.start(Vector3(1, 0, 0), Vector3.UP)
	assert_push_error("1.5")
	assert_eq(_orbit.get_radius(), 5.0)
	_orbit.start(Vector3(6, 0, 0), Vector3.UP)
	assert_eq(_orbit.get_error_message(), "")
