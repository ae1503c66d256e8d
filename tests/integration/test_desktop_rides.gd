# SPDX-License-Identifier: MIT
extends "res://tests/integration/desktop_test.gd"
## Rides take the eye and the observer along, and keys and buttons lead them.

var _rides: RideDirector


func before_each() -> void:
	super()
	_rides = _scene.get_node("Rides")
	_rides.set_process(false)


func _press_key(key: Key) -> void:
	get_tree().root.push_input(_key_event(key))
	get_tree().root.push_input(_key_event(key, false))


func _press_button(button: JoyButton) -> void:
	get_tree().root.push_input(_button_event(button))
	get_tree().root.push_input(_button_event(button, false))


func _ride(seconds: float) -> void:
	for i in ceili(seconds * 20.0):
		_rides.advance(0.05)
		_controls.advance(0.05)


func _text(label_name: String) -> String:
	var bar: RideBar = _scene.get_node("%RideBar")
	bar.update()
	return (bar.get_node("%" + label_name) as Label).text


func test_the_long_fall_from_start_to_end() -> void:
	assert_true(_rides.start(RideDirector.Kind.FROM_REST))
	assert_almost_eq(_controls.rig.get_distance(), 30.0, 1e-4)
	assert_eq(_sky.observer_motion, LensingTable.MOTION_INFALL)
	assert_true((_scene.get_node("%RideBar") as Control).visible)
	_ride(10.0)
	assert_between(_controls.rig.get_distance(), 1.0, 29.9)
	assert_almost_eq(_controls.rig.get_distance(), _rides.ride.get_place().length(), 1e-5)
	_ride(90.0)
	assert_almost_eq(_controls.rig.get_distance(), Ride.NEAREST, 1e-5)
	assert_true(_rides.pace.paused)
	assert_string_contains(_notices.get_text(RideDirector.TOPIC), "centre")
	var place := _controls.rig.get_position()
	assert_eq(_sky.get_observer_refusal_at(place), "", "the motion exists to the end")
	_press_key(KEY_BACKSPACE)
	_ride(5.0)
	assert_gt(_controls.rig.get_distance(), 2.0 * Ride.NEAREST, "back again")
	_press_key(KEY_X)
	assert_false(_rides.is_on())
	assert_false((_scene.get_node("%RideBar") as Control).visible)
	assert_eq(_controls.mode, ViewControls.Mode.ORBIT)


func test_keys_and_buttons_lead_a_ride() -> void:
	_rides.start(RideDirector.Kind.AS_RAIN)
	_press_key(KEY_SPACE)
	assert_true(_rides.pace.paused)
	var place := _controls.rig.get_position()
	_ride(1.0)
	assert_eq(_controls.rig.get_position(), place)
	_press_button(JOY_BUTTON_X)
	assert_false(_rides.pace.paused)
	assert_eq(_sky.observer_motion, LensingTable.MOTION_INFALL, "the button has no second meaning")
	_press_key(KEY_COMMA)
	_press_button(JOY_BUTTON_DPAD_LEFT)
	assert_almost_eq(_rides.pace.get_factor(), 0.25, 1e-9)
	assert_true((_scene.get_node("%Readouts") as Control).visible, "nor has that one")
	_press_key(KEY_PERIOD)
	_press_button(JOY_BUTTON_DPAD_RIGHT)
	assert_almost_eq(_rides.pace.get_factor(), 1.0, 1e-9)
	_press_button(JOY_BUTTON_Y)
	assert_true(_rides.pace.reversed)
	_hold(_key_event(KEY_K))
	_ride(1.0)
	_hold(_key_event(KEY_K, false))
	assert_lt(_controls.rig.get_distance(), 20.0, "forward while held, whatever the pace")
	_press_button(JOY_BUTTON_B)
	assert_false(_rides.is_on())
	assert_true((_scene.get_node("Switches") as SkySwitches).is_hole_wanted())


func test_one_looks_round_on_a_ride() -> void:
	_rides.start(RideDirector.Kind.FROM_REST)
	var forward := _controls.rig.get_orientation() * Vector3.FORWARD
	_hold(_key_event(KEY_RIGHT))
	_ride(0.5)
	_hold(_key_event(KEY_RIGHT, false))
	_ride(1.0)
	var turned := _controls.rig.get_orientation() * Vector3.FORWARD
	assert_between(forward.angle_to(turned), 0.2, 1.0)
	_press_key(KEY_F)
	assert_eq(_controls.gaze, ViewControls.Gaze.HOLE)
	_ride(3.0)
	var ahead := _controls.rig.get_orientation() * Vector3.FORWARD
	assert_lt(ahead.angle_to(forward), 0.01)
	_press_key(KEY_F)
	_ride(3.0)
	assert_lt((_controls.rig.get_orientation() * Vector3.FORWARD).angle_to(-forward), 0.01)


func test_what_the_ride_decides_cannot_be_switched() -> void:
	_rides.start(RideDirector.Kind.AS_RAIN)
	_press_key(KEY_O)
	assert_eq(_sky.observer_motion, LensingTable.MOTION_INFALL)
	assert_string_contains(_notices.get_text(RideDirector.TOPIC), "X or B")
	_press_key(KEY_L)
	assert_true((_scene.get_node("Switches") as SkySwitches).is_hole_wanted())
	_press_key(KEY_HOME)
	assert_false(_rides.is_on())
	assert_almost_eq(_controls.rig.get_distance(), StartView.DISTANCE, 1e-4)


func test_an_orbit_is_refused_where_there_is_none() -> void:
	_controls.rig.place(Vector3(0.0, 0.0, 1.4), Quaternion.IDENTITY)
	assert_false(_rides.start(RideDirector.Kind.ORBIT_LEFT))
	assert_false(_rides.is_on())
	assert_string_contains(_notices.get_text(RideDirector.TOPIC), "1.5")


func test_an_orbit_goes_on_and_keeps_its_distance() -> void:
	_controls.rig.look_from(Vector3(0.0, 0.0, 4.0), Vector3.UP)
	_rides.start(RideDirector.Kind.ORBIT_RIGHT)
	_ride(3.0)
	assert_gt(_controls.rig.get_position().x, 0.5, "to the right")
	assert_almost_eq(_controls.rig.get_distance(), 4.0, 1e-4)
	assert_eq(_sky.observer_motion, LensingTable.MOTION_ORBIT)
	assert_string_contains(_text("Title"), "4.000")


func test_a_flight_obeys_the_stick() -> void:
	_rides.start(RideDirector.Kind.PILOTED)
	_hold(_key_event(KEY_S))
	_ride(0.1)
	var thrust := PilotedRide.full_thrust(StartView.DISTANCE) * _sky.get_acceleration_unit_g()
	assert_eq(_text("Thrust"), "%s g" % ReadoutText.counted(thrust))
	_ride(4.0)
	_hold(_key_event(KEY_S, false))
	assert_gt(_controls.rig.get_distance(), 1.1 * StartView.DISTANCE, "away from the hole")
	assert_eq(_sky.observer_motion, LensingTable.MOTION_VELOCITY)
	_ride(0.1)
	assert_eq(_text("ThrustNatural"), "free fall")
	_press_key(KEY_BACKSPACE)
	assert_string_contains(_notices.get_text(RideDirector.TOPIC), "reversed")


func test_the_flight_without_the_hole() -> void:
	_rides.start(RideDirector.Kind.VELOCITY)
	assert_false((_scene.get_node("Switches") as SkySwitches).is_hole_wanted())
	_sky.lensing = 0.0
	_hold(_key_event(KEY_W))
	_ride(8.0)
	_hold(_key_event(KEY_W, false))
	assert_almost_eq(_sky.observer.celerity.length(), 0.9 / sqrt(1.0 - 0.81), 1e-3)
	var forward := _controls.rig.get_orientation() * Vector3.FORWARD
	assert_lt(_sky.observer.celerity.angle_to(forward), 1e-3)
	# Doppler factor straight ahead: sqrt((1 + 0.9) / (1 - 0.9)).
	assert_eq(_text("Far"), ReadoutText.clock_rate(sqrt(19.0)))
	_rides.leave()
	assert_true((_scene.get_node("Switches") as SkySwitches).is_hole_wanted())
	assert_eq(_sky.observer_motion, LensingTable.MOTION_STATIC)


func test_the_clocks_of_rain() -> void:
	_rides.start(RideDirector.Kind.AS_RAIN)
	_rides.seek((_rides.ride as FallRide).progress_of(1.0))
	# Rain: tau = T = 2/3 (30^1.5 - 1), far clocks at 1 / (1 + sqrt u).
	var time := (pow(30.0, 1.5) - 1.0) * 2.0 / 3.0
	assert_eq(_text("Own"), ReadoutText.natural_time(time))
	assert_eq(_text("Rain"), ReadoutText.natural_time(time))
	assert_eq(_text("OwnSeconds"), ReadoutText.duration(time * _sky.get_time_unit_seconds()))
	assert_eq(_text("Far"), "× 0.5000")
	assert_eq(_text("Thrust"), "0 g")
