# SPDX-License-Identifier: MIT
extends GutTest
## Rides follow their world lines, and their pace is what was asked for.


func test_the_long_fall_takes_as_long_as_it_should() -> void:
	var ride := FallRide.from_rest(30.0, Vector3.RIGHT)
	assert_eq(ride.refusal, "")
	assert_almost_eq(ride.get_place(), Vector3(30.0, 0.0, 0.0), Vector3.ONE * 1e-4)
	# The cycloid: r = R (1 + cos eta) / 2, tau = R^1.5 (eta + sin eta) / 2.
	for radius: float in [29.0, 3.0, 1.0, 0.3, Ride.NEAREST]:
		var eta := acos(2.0 * radius / 30.0 - 1.0)
		ride.seek(ride.progress_of(radius))
		assert_almost_eq(ride.get_radius(), radius, 1e-9 * 30.0)
		assert_almost_eq(ride.get_proper_time(), 0.5 * pow(30.0, 1.5) * (eta + sin(eta)), 1e-6)


func test_a_fall_ends_before_the_centre_and_at_its_start() -> void:
	var ride := FallRide.as_rain(30.0, Vector3.UP)
	assert_true(ride.advance(1.0))
	assert_false(ride.advance(1e4))
	assert_almost_eq(ride.get_radius(), Ride.NEAREST, 1e-6)
	assert_almost_eq(ride.get_progress(), 1.0, 1e-6)
	assert_true(ride.advance(-1.0), "back")
	assert_gt(ride.get_radius(), 1.0)
	assert_false(ride.advance(-1e4))
	assert_almost_eq(ride.get_radius(), 30.0, 1e-9)
	assert_eq(ride.get_progress(), 0.0)


func test_a_fall_from_rest_needs_an_outside() -> void:
	assert_ne(FallRide.from_rest(1.0, Vector3.UP).refusal, "")
	assert_eq(FallRide.from_rest(1.1, Vector3.UP).refusal, "")


func test_the_sky_moves_with_the_fall() -> void:
	var ride := FallRide.from_rest(8.0, Vector3.BACK)
	var observer := SkyObserver.new()
	for radius: float in [7.9, 2.0, 1.0, 0.2]:
		ride.seek(ride.progress_of(radius))
		ride.set_motion(observer)
		var expected := ride.get_celerity()
		assert_almost_eq(observer.celerity_at(ride.get_place()), expected, Vector3.ONE * 1e-4)


func test_an_orbit_closes_and_the_sky_moves_with_it() -> void:
	var place := Vector3(3.0, 0.0, 0.0)
	var ride := OrbitRide.from(place, Vector3.UP)
	assert_true(ride.is_stable())
	ride.seek(0.25)
	assert_almost_eq(ride.get_place(), Vector3(0.0, 0.0, -3.0), Vector3.ONE * 1e-5)
	# Proper time of a turn: 2 pi r sqrt(2 r) sqrt(1 - 1.5 / r).
	assert_almost_eq(ride.get_proper_time(), 0.25 * TAU * 3.0 * sqrt(6.0) * sqrt(0.5), 1e-6)
	var observer := SkyObserver.new()
	ride.set_motion(observer)
	assert_almost_eq(
		observer.celerity_at(ride.get_place()), ride.get_celerity(), Vector3.ONE * 1e-5
	)
	assert_true(is_finite(ride.get_far_clock_rate()))
	assert_ne(OrbitRide.from(Vector3(1.5, 0.0, 0.0), Vector3.UP).refusal, "")
	assert_ne(OrbitRide.from(place, Vector3.RIGHT).refusal, "", "no plane")


func test_who_is_dropped_can_be_there_whatever_rounding_does() -> void:
	var observer := SkyObserver.new()
	var refused := 0
	for i in 500:
		var place := Vector3(sin(i), cos(2.0 * i), sin(3.0 * i)).normalized() * (1.0001 + 0.05 * i)
		var ride := FallRide.from_rest(place.length(), place)
		ride.set_motion(observer)
		refused += 0 if observer.get_refusal(ride.get_place()).is_empty() else 1
	assert_eq(refused, 0)


func test_a_flight_goes_on_with_the_motion_that_is_there() -> void:
	var place := Vector3(0.0, 0.0, 5.0)
	var still := SkyObserver.new()
	var ride := PilotedRide.from(place, still.celerity_at(place))
	assert_almost_eq(ObserverSpeed.of(ride.get_celerity(), place), 0.0, 1e-6)
	# Its weight u^2 / (2 sqrt(1 - u)) as a share of the full thrust holds it.
	var weight := 0.5 / 25.0 / sqrt(1.0 - 0.2)
	ride.steer(Vector3.BACK * (weight / PilotedRide.full_thrust(5.0)), 0.1)
	assert_almost_eq(ride.get_thrust(), Vector3.BACK * weight, Vector3.ONE * 1e-7)
	assert_true(ride.advance(1.0))
	assert_almost_eq(ride.get_place().z, 5.0, 1e-4)
	ride.steer(Vector3.ZERO, 0.1)
	assert_false(ride.advance(1e3), "falls to the end")
	assert_false(ride.is_reversible())


func test_the_stick_sets_the_speed_without_the_hole() -> void:
	var ride := VelocityRide.from(Vector3.BACK * 12.0, Vector3.FORWARD)
	ride.change_top_speed(99)
	assert_almost_eq(ride.get_top_speed(), 0.999, 1e-9)
	for i in 1000:
		ride.steer(Vector3.FORWARD, 0.02)
	var beta := ObserverSpeed.from_celerity(ride.get_celerity().length())
	assert_almost_eq(beta, 0.999, 1e-6)
	assert_almost_eq(ride.get_far_clock_rate(), sqrt(1.999 / 0.001), 1e-2, "blue ahead")
	ride.look_along(Vector3.BACK)
	assert_almost_eq(ride.get_far_clock_rate(), sqrt(0.001 / 1.999), 1e-5, "red behind")
	assert_almost_eq(ride.get_proper_time(), 20.0, 1e-6)
	assert_gt(ride.get_rain_time(), 15.0 / sqrt(1.0 - 0.999 * 0.999))
	ride.set_held(true)
	ride.steer(Vector3.ZERO, 5.0)
	assert_almost_eq(ObserverSpeed.from_celerity(ride.get_celerity().length()), beta, 1e-9)
	ride.set_held(false)
	ride.steer(Vector3.ZERO, 30.0)
	assert_almost_eq(ride.get_celerity(), Vector3.ZERO, Vector3.ONE * 1e-6)


func test_the_pace() -> void:
	var pace := RidePace.new()
	assert_almost_eq(pace.passed(4.0, 0.5), 0.5 * RidePace.SHARE * 8.0, 1e-9)
	pace.change(-2)
	assert_almost_eq(pace.get_factor(), 0.25, 1e-9)
	assert_eq(pace.get_factor_text(), "1/4")
	pace.reversed = true
	assert_lt(pace.passed(4.0, 0.5), 0.0)
	pace.paused = true
	assert_eq(pace.passed(4.0, 0.5), 0.0)
	pace.change(99)
	assert_eq(pace.get_factor_text(), "16")
	pace.reset()
	assert_almost_eq(pace.passed(1.0, 1.0), RidePace.SHARE, 1e-9)
