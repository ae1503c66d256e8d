# SPDX-License-Identifier: MIT
extends "res://tests/integration/desktop_test.gd"
## Keyboard, mouse and gamepad move the eye.


func _push_stick(axis: JoyAxis, value: float) -> void:
	var event := InputEventJoypadMotion.new()
	event.axis = axis
	event.axis_value = value
	_hold(event)


# `share` of the window's height.
func _drag_mouse(share: Vector2) -> void:
	var way := share * get_tree().root.get_visible_rect().size.y
	var button := InputEventMouseButton.new()
	button.button_index = MOUSE_BUTTON_LEFT
	button.pressed = true
	button.position = Vector2(300.0, 300.0)
	get_tree().root.push_input(button)
	var motion := InputEventMouseMotion.new()
	motion.position = button.position + way
	motion.relative = way
	motion.button_mask = MOUSE_BUTTON_MASK_LEFT
	get_tree().root.push_input(motion)
	var release := button.duplicate() as InputEventMouseButton
	release.pressed = false
	get_tree().root.push_input(release)


func _turn_wheel(button_index: MouseButton) -> void:
	for pressed: bool in [true, false]:
		var event := InputEventMouseButton.new()
		event.button_index = button_index
		event.pressed = pressed
		event.position = Vector2(300.0, 300.0)
		get_tree().root.push_input(event)


func test_arrow_keys_and_right_stick_go_round_the_hole() -> void:
	var start := _controls.rig.get_position()
	var right := _controls.rig.get_orientation() * Vector3.RIGHT
	_hold(_key_event(KEY_RIGHT))
	_let_pass(0.5)
	_hold(_key_event(KEY_RIGHT, false))
	var by_key := _controls.rig.get_position()
	assert_gt((by_key - start).dot(right), 1.0, "to the right")
	assert_almost_eq(by_key.length(), StartView.DISTANCE, 1e-3)
	_controls.reset()
	_push_stick(JOY_AXIS_RIGHT_X, 1.0)
	_let_pass(0.5)
	_push_stick(JOY_AXIS_RIGHT_X, 0.0)
	assert_lt(_controls.rig.get_position().distance_to(by_key), 1e-2, "the stick does the same")


func test_wheel_keys_and_triggers_change_the_distance() -> void:
	_turn_wheel(MOUSE_BUTTON_WHEEL_UP)
	_let_pass(1.0)
	var expected := StartView.DISTANCE * exp(-ViewControls.WHEEL_STEP)
	assert_almost_eq(_controls.rig.get_distance(), expected, 1e-3, "one notch nearer")
	_turn_wheel(MOUSE_BUTTON_WHEEL_DOWN)
	_let_pass(1.0)
	assert_almost_eq(_controls.rig.get_distance(), StartView.DISTANCE, 1e-3, "and back")
	_hold(_key_event(KEY_PAGEUP))
	_let_pass(0.5)
	_hold(_key_event(KEY_PAGEUP, false))
	_let_pass(1.0)
	var nearer := _controls.rig.get_distance()
	assert_lt(nearer, 0.9 * StartView.DISTANCE)
	_push_stick(JOY_AXIS_TRIGGER_LEFT, 1.0)
	_let_pass(0.5)
	_push_stick(JOY_AXIS_TRIGGER_LEFT, 0.0)
	assert_gt(_controls.rig.get_distance(), 1.1 * nearer)


func test_dragging_goes_round_or_looks_round() -> void:
	var start := _controls.rig.get_position()
	_drag_mouse(Vector2(0.15, 0.0))
	_let_pass(1.0)
	var right := _controls.rig.get_orientation() * Vector3.RIGHT
	assert_lt((_controls.rig.get_position() - start).dot(right), -1.0, "the eye goes to the left")
	_controls.reset()
	_controls.mode = ViewControls.Mode.FLIGHT
	var forward := _controls.rig.get_orientation() * Vector3.FORWARD
	_drag_mouse(Vector2(0.15, 0.0))
	_let_pass(1.0)
	assert_almost_eq(_controls.rig.get_position(), start, Vector3.ONE * 1e-3)
	var turned := forward.angle_to(_controls.rig.get_orientation() * Vector3.FORWARD)
	assert_gt(turned, deg_to_rad(3.0))


func test_a_mouse_that_is_not_pressed_moves_nothing() -> void:
	var motion := InputEventMouseMotion.new()
	motion.relative = Vector2(400.0, 200.0)
	motion.position = Vector2(300.0, 300.0)
	get_tree().root.push_input(motion)
	var start := _controls.rig.get_position()
	_let_pass(0.5)
	assert_almost_eq(_controls.rig.get_position(), start, Vector3.ONE * 1e-4)


func test_flight_forward_by_key_and_stick() -> void:
	_controls.mode = ViewControls.Mode.FLIGHT
	_hold(_key_event(KEY_W))
	_let_pass(1.0)
	_hold(_key_event(KEY_W, false))
	_let_pass(1.0)
	var nearer := _controls.rig.get_distance()
	assert_almost_eq(nearer, StartView.DISTANCE * exp(-ViewControls.FLIGHT_SPEED), 0.05)
	_push_stick(JOY_AXIS_LEFT_Y, 1.0)
	_let_pass(1.0)
	_push_stick(JOY_AXIS_LEFT_Y, 0.0)
	_let_pass(1.0)
	assert_almost_eq(_controls.rig.get_distance(), StartView.DISTANCE, 0.1, "back again")


func test_a_flight_into_the_hole_turns_the_observer_to_rain() -> void:
	_controls.mode = ViewControls.Mode.FLIGHT
	_hold(_key_event(KEY_W))
	_let_pass(8.0)
	_hold(_key_event(KEY_W, false))
	assert_lt(_controls.rig.get_distance(), 1.0)
	await wait_process_frames(2)
	assert_eq(_sky.observer_motion, LensingTable.MOTION_RAIN)
	assert_string_contains(_notices.get_text(ObserverChoice.TOPIC), "horizon")
	_hold(_key_event(KEY_W))
	_let_pass(60.0)
	_hold(_key_event(KEY_W, false))
	assert_between(_controls.rig.get_distance(), 0.99 * ViewRig.NEAREST, 1.01 * ViewRig.FARTHEST)
	assert_true((_scene.get_node("Camera") as Camera3D).global_transform.is_finite())


func test_long_frames_go_as_far_as_short_ones() -> void:
	_controls.mode = ViewControls.Mode.FLIGHT
	_hold(_key_event(KEY_W))
	_hold(_key_event(KEY_D))
	for i in 5:
		_controls.advance(0.2)
	var coarse := _controls.rig.get_position()
	_controls.reset()
	_controls.mode = ViewControls.Mode.FLIGHT
	for i in 200:
		_controls.advance(0.005)
	assert_lt(_controls.rig.get_position().distance_to(coarse), 1e-3)
