# SPDX-License-Identifier: MIT
extends GutTest
## What the cards say of a place, against values of the exact solution.

var _figures: PlaceFigures
var _sky: BlackHoleSky
var _camera: Camera3D
var _disk: AccretionDisk


func before_each() -> void:
	_sky = BlackHoleSky.new()
	_camera = Camera3D.new()
	_disk = AccretionDisk.new()
	_sky.add_child(_disk)
	add_child_autofree(_sky)
	add_child_autofree(_camera)
	_figures = PlaceFigures.new()
	_figures.sky = _sky
	_figures.camera = _camera
	_figures.disk = _disk


func _stand(radius: float) -> void:
	_camera.position = Vector3(2.0, -1.0, 2.0).normalized() * radius


func test_at_rest_at_ten_radii(
	p: Array = use_parameters(
		[
			[&"shadow", "28.54°"],
			[&"ring", "59.66°"],
			[&"second_ring", "0.3400°"],
			[&"gravitational_shift", "1.054 times"],
			[&"rain", "0.3162 times"],
			[&"orbit", "0.2357 of"],
			[&"orbit", "is stable"],
			[&"photon_sphere", "10.00 rₛ, outside"],
			[&"doppler", "at rest"],
			[&"aberration", "at rest"],
		]
	)
) -> void:
	_stand(10.0)
	var figure: StringName = p[0]
	assert_string_contains(_figures.line(figure), p[1])


func test_light_is_bent_outwards_and_magnified() -> void:
	# 20 degrees from the point behind the hole: beyond that, outside the ring.
	_stand(10.0)
	var seen := _figures.line(&"deflection").get_slice("at ", 1).to_float()
	assert_gt(seen, 29.83, "outside the ring")
	assert_lt(seen, 29.83 + 20.0)
	var factor := _figures.line(&"magnification").get_slice("magnified ", 1).to_float()
	# Near the axis: half of the ring's angle over the star's, about.
	assert_between(factor, 5.0, 40.0)


func test_on_the_circular_orbit_at_three() -> void:
	_stand(3.0)
	_sky.observer = SkyObserver.new()
	_sky.observer.motion = LensingTable.MOTION_ORBIT
	assert_string_contains(_figures.line(&"orbit"), "0.5000")
	assert_string_contains(_figures.line(&"doppler"), "0.5000 c")
	assert_string_contains(_figures.line(&"doppler"), "1.732 times")
	assert_string_contains(_figures.line(&"aberration"), "60.00°")


func test_inside_the_horizon() -> void:
	_stand(0.25)
	_sky.observer = SkyObserver.new()
	_sky.observer.motion = LensingTable.MOTION_RAIN
	assert_string_contains(_figures.line(&"rain"), "2.000 times")
	assert_string_contains(_figures.line(&"gravitational_shift"), "Nobody rests")
	assert_string_contains(_figures.line(&"orbit"), "no circular orbit")
	assert_string_contains(_figures.line(&"photon_sphere"), "inside")


func test_everywhere_something_is_said() -> void:
	for radius: float in [0.03, 0.9, 1.0, 1.2, 1.5, 2.9, 30.0, 1000.0]:
		_stand(radius)
		for motion: LensingTable.Motion in [
			LensingTable.MOTION_STATIC, LensingTable.MOTION_RAIN, LensingTable.MOTION_ORBIT
		]:
			_sky.observer_motion = motion
			for figure in _figures.get_names():
				var line := _figures.line(figure)
				assert_ne(line, "")
				assert_false(
					line.contains("nan") or line.contains("–"), "%s at %s" % [line, radius]
				)


func test_without_the_hole_there_is_nothing_to_say() -> void:
	_stand(10.0)
	_sky.lensing = 0.0
	assert_eq(_figures.line(&"shadow"), "The hole is switched off.")
	assert_eq(_figures.line(&"nonsense"), "")


func test_the_disk_that_is_shown() -> void:
	_stand(10.0)
	_disk.peak_temperature = 5600.0
	assert_string_contains(_figures.line(&"disk"), "5600 K")
	_disk.hide()
	assert_string_contains(_figures.line(&"disk"), "switched off")
