# SPDX-License-Identifier: MIT
extends SettingsCase
## What the settings do to keys, sticks and mouse.

const DT: float = 0.02


func _hold(action: StringName) -> void:
	Input.action_press(action)


func _turned_after(seconds: float) -> Vector3:
	_controls.reset()
	_controls.mode = ViewControls.Mode.FLIGHT
	for i in roundi(seconds / DT):
		_controls.advance(DT)
	return _controls.rig.get_orientation() * Vector3.FORWARD


func test_speed_of_sticks_and_keys() -> void:
	_hold(&"look_right")
	var once := _turned_after(0.5).angle_to(Vector3(_turned_after(0.0)))
	_settings.set_value(&"stick_sensitivity", 200.0)
	var twice := _turned_after(0.5).angle_to(Vector3(_turned_after(0.0)))
	assert_almost_eq(twice, 2.0 * once, 1e-3)


func test_speed_of_the_mouse() -> void:
	var angles: Array[float] = []
	for percent: float in [100.0, 200.0]:
		_settings.set_value(&"mouse_sensitivity", percent)
		var before := _turned_after(0.0)
		_controls._dragging = true
		_controls._drag(Vector2(30.0, 0.0))
		for i in 100:
			_controls.advance(DT)
		angles.append((_controls.rig.get_orientation() * Vector3.FORWARD).angle_to(before))
	assert_gt(angles[0], 0.01)
	assert_almost_eq(angles[1], 2.0 * angles[0], 1e-3)


func test_up_and_down_the_other_way_round() -> void:
	_hold(&"look_up")
	var up := _turned_after(0.5)
	_settings.set_value(&"invert_y", true)
	var down := _turned_after(0.5)
	var level := _turned_after(0.0)
	assert_gt((up - level).length(), 0.1)
	assert_almost_eq((up + down).normalized().dot(level), 1.0, 1e-4)


func test_flying_faster_on_and_off() -> void:
	_settings.set_value(&"fast_mode", "toggle")
	_hold(&"look_right")
	_hold(&"fly_forward")
	_turned_after(0.5)
	var slow := _controls.rig.get_distance()
	var press := InputEventAction.new()
	press.action = &"fly_fast"
	press.pressed = true
	_controls._unhandled_input(press)
	_turned_after(0.5)
	assert_lt(_controls.rig.get_distance(), slow - 0.5, "without being held")
	_controls._unhandled_input(press)
	_turned_after(0.5)
	assert_almost_eq(_controls.rig.get_distance(), slow, 1e-3)


func test_dead_zone() -> void:
	_settings.set_value(&"stick_dead_zone", 40.0)
	assert_almost_eq(InputMap.action_get_deadzone(&"look_left"), 0.4, 1e-5)
	var event := InputEventJoypadMotion.new()
	event.axis = JOY_AXIS_RIGHT_X
	event.axis_value = -0.35
	assert_false(event.is_action_pressed(&"look_left"))
	assert_ne(InputMap.action_get_deadzone(&"ui_left"), 0.4, "menus keep theirs")


func test_bindings() -> void:
	_settings.set_value(&"bindings", {"toggle_flight": ["key:U"]})
	var event := InputEventKey.new()
	event.physical_keycode = KEY_U
	assert_true(InputMap.event_is_action(event, &"toggle_flight"))
	_settings.set_value(&"bindings", {})
	assert_false(InputMap.event_is_action(event, &"toggle_flight"))


func test_less_motion() -> void:
	_settings.set_value(&"reduced_motion", true)
	_hold(&"look_right")
	_turned_after(0.5)
	Input.action_release(&"look_right")
	_controls.advance(DT)
	var stopped := _controls.rig.get_orientation()
	for i in 20:
		_controls.advance(DT)
	assert_true(_controls.rig.get_orientation().is_equal_approx(stopped), "it stops at once")
	_switches.toggle_lensing()
	assert_eq(_sky.lensing, 0.0, "the hole is gone at once")
	assert_eq(_clock.rate, SettingsEffects.GENTLE_DISK)
	_settings.set_value(&"reduced_motion", false)
	assert_eq(_clock.rate, 10.0)
	assert_true(_switches.gradual and _controls.eased)
