# SPDX-License-Identifier: MIT
extends GutTest
## The speed on the display against what textbooks have.

const CLOSE: float = 1e-6


func _speed(observer: SkyObserver, radius: float) -> float:
	var place := Vector3(0.0, radius, 0.0)
	return ObserverSpeed.of(observer.celerity_at(place), place)


func _observer(motion: LensingTable.Motion) -> SkyObserver:
	var observer := SkyObserver.new()
	observer.motion = motion
	return observer


func test_the_static_observer_stands() -> void:
	for radius: float in [1.2, 3.0, 100.0]:
		assert_almost_eq(_speed(_observer(LensingTable.MOTION_STATIC), radius), 0.0, CLOSE)


func test_rain_falls_with_the_escape_speed() -> void:
	for radius: float in [1.01, 4.0, 25.0]:
		var speed := _speed(_observer(LensingTable.MOTION_RAIN), radius)
		assert_almost_eq(speed, 1.0 / sqrt(radius), CLOSE)
	assert_almost_eq(_speed(_observer(LensingTable.MOTION_RAIN), 0.5), 0.0, CLOSE, "against itself")


# v^2 = M / (r - 2 M), with M = 1/2; half the speed of light on the last stable orbit.
func test_orbits() -> void:
	var orbit := _observer(LensingTable.MOTION_ORBIT)
	orbit.axis = Vector3.BACK
	assert_almost_eq(_speed(orbit, 3.0), 0.5, CLOSE)
	for radius: float in [1.6, 2.0, 10.0]:
		assert_almost_eq(_speed(orbit, radius), sqrt(0.5 / (radius - 1.0)), 1e-5)


func test_a_velocity_given_relative_to_the_static_observer() -> void:
	var flyer := _observer(LensingTable.MOTION_VELOCITY)
	flyer.relative_to_static = true
	flyer.celerity = SkyObserver.celerity_from_velocity(Vector3(0.3, -0.5, 0.2))
	assert_almost_eq(_speed(flyer, 2.0), Vector3(0.3, -0.5, 0.2).length(), 1e-5)


func test_inside_it_is_relative_to_rain() -> void:
	var flyer := _observer(LensingTable.MOTION_VELOCITY)
	flyer.celerity = SkyObserver.celerity_from_velocity(Vector3(0.6, 0.0, 0.0))
	assert_almost_eq(_speed(flyer, 0.5), 0.6, CLOSE)
