# SPDX-License-Identifier: MIT
extends GutTest
## Falls along a radius as scripts reach them: closed forms, scrubbing, refusals.

var _fall: RadialFallPath


func before_each() -> void:
	_fall = RadialFallPath.new()


func test_rain_has_the_closed_form() -> void:
	assert_eq(_fall.start_with_energy(30.0, 1.0), OK)
	assert_true(_fall.is_ready())
	assert_eq(_fall.get_energy(), 1.0)
	assert_eq(_fall.get_start_radius(), 30.0)
	assert_eq(_fall.get_highest_radius(), INF)
	assert_almost_eq(_fall.get_duration(), _rain_time(0.0), 1e-10)
	for radius: float in [20.0, 1.0, 0.05]:
		var time := _rain_time(radius)
		assert_almost_eq(_fall.proper_time_to(radius), time, 1e-10)
		assert_almost_eq(_fall.radius_at(time), radius, 1e-10)
		assert_almost_eq(_fall.rain_time_at(time), time, 1e-10)
		assert_eq(_fall.radial_celerity_at(time), 0.0)
		assert_almost_eq(_fall.far_clock_rate_at(time), 1.0 / (1.0 + sqrt(1.0 / radius)), 1e-10)


func test_from_rest_is_half_a_cycloid() -> void:
	assert_eq(_fall.start_from_rest(30.0), OK)
	assert_eq(_fall.get_highest_radius(), 30.0)
	assert_almost_eq(_fall.get_energy(), sqrt(29.0 / 30.0), 1e-15)
	assert_almost_eq(_fall.get_duration(), 0.5 * PI * pow(30.0, 1.5), 1e-9)
	for angle: float in [0.5, 2.0, 3.0]:
		var time := 0.5 * pow(30.0, 1.5) * (angle + sin(angle))
		assert_almost_eq(_fall.radius_at(time), 15.0 * (1.0 + cos(angle)), 1e-10)
	# At the start the observer is static: so says the celerity.
	assert_almost_eq(_fall.radial_celerity_at(0.0), sqrt(1.0 / 29.0), 1e-12)
	assert_almost_eq(_fall.far_clock_rate_at(0.0), 1.0 / sqrt(29.0 / 30.0), 1e-7)


func test_a_ride_can_be_scrubbed_past_its_ends() -> void:
	_fall.start_with_energy(2.0, 1.0)
	assert_almost_eq(_fall.radius_at(-5.0), 2.0, 1e-14)
	assert_eq(_fall.rain_time_at(-5.0), 0.0)
	for late: float in [_fall.get_duration(), 1e9, INF]:
		assert_almost_eq(_fall.radius_at(late), 1e-6, 1e-9)
		assert_almost_eq(_fall.rain_time_at(late), _fall.get_duration(), 1e-8)
	assert_true(is_nan(_fall.radius_at(NAN)))


func test_there_and_back_is_the_same() -> void:
	_fall.start_from_rest(30.0)
	var forward: Array[float] = []
	for frame in 60:
		forward.append(_fall.radius_at(4.2 * frame))
		assert_true(frame == 0 or forward[frame] < forward[frame - 1])
	for frame in range(59, -1, -1):
		assert_eq(_fall.radius_at(4.2 * frame), forward[frame])


func test_thrown_up_it_turns_and_comes_back() -> void:
	assert_eq(_fall.start_with_energy(2.0, 0.8, true), OK)
	var turn := _fall.proper_time_to(_fall.get_highest_radius())
	assert_true(_fall.is_outward_at(0.5 * turn))
	assert_false(_fall.is_outward_at(1.5 * turn))
	assert_almost_eq(_fall.radius_at(0.5 * turn), _fall.radius_at(1.5 * turn), 1e-12)
	assert_gt(_fall.get_duration(), 2.0 * turn)


func test_places_and_celerities_in_the_world() -> void:
	_fall.start_with_energy(10.0, 1.5)
	var time := _fall.proper_time_to(4.0)
	var outward := Vector3(0, 0, 2)
	assert_almost_eq(_fall.position_at(time, outward), Vector3(0, 0, 4), Vector3.ONE * 1e-6)
	var celerity := _fall.celerity_at(time, outward)
	assert_almost_eq(celerity, Vector3(0, 0, _fall.radial_celerity_at(time)), Vector3.ONE * 1e-6)
	assert_lt(celerity.z, 0.0, "faster than rain")
	assert_eq(_fall.position_at(time, Vector3.ZERO), Vector3.ZERO)


func test_what_is_impossible_is_refused_by_name(
	# radius, energy, outward, words of the message
	p: Array = use_parameters(
		[
			[3.0, 0.6, false, "energy 0.6 is too small for r = 3 r_s"],
			[3.0, 0.0, false, "positive"],
			[3.0, NAN, false, "positive"],
			[1.0, 2.0, true, "horizon"],
			[0.5, 2.0, true, "horizon"],
			[0.0, 1.0, false, "centre"],
			[-1.0, 1.0, false, "radius"],
			[NAN, 1.0, false, "radius"],
		]
	)
) -> void:
	assert_eq(_fall.start_with_energy(p[0], p[1], p[2]), ERR_INVALID_PARAMETER)
	assert_push_error(p[3])
	assert_string_contains(_fall.get_error_message(), p[3])
	assert_false(_fall.is_ready())
	assert_true(is_nan(_fall.get_duration()))
	assert_true(is_nan(_fall.radius_at(0.0)))
	assert_eq(_fall.position_at(0.0, Vector3.UP), Vector3.ZERO)


func test_a_refused_start_leaves_the_path() -> void:
	_fall.start_from_rest(4.0)
	assert_eq(_fall.start_from_rest(1.0), ERR_INVALID_PARAMETER)
	assert_push_error("horizon")
	assert_eq(_fall.get_start_radius(), 4.0)
	assert_eq(_fall.start_from_rest(5.0), OK)
	assert_eq(_fall.get_error_message(), "", "a good start clears the message")
	assert_true(is_nan(_fall.proper_time_to(6.0)), "it never is there")


func _rain_time(radius: float) -> float:
	return 2.0 / 3.0 * (pow(30.0, 1.5) - pow(radius, 1.5))
