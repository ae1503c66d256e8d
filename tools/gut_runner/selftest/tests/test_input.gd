# SPDX-License-Identifier: MIT
extends GutTest
## Sending input events.


class Receiver:
	extends Node

	var events: Array[InputEvent] = []

	func _input(event: InputEvent) -> void:
		events.append(event)


var _sender: GutInputSender = GutInputSender.new(Input)


func after_each() -> void:
	_sender.release_all()
	_sender.clear()


func test_pass_action() -> void:
	_sender.action_down("jump")
	await wait_process_frames(2)
	assert_true(Input.is_action_pressed("jump"))
	_sender.action_up("jump")
	await wait_process_frames(2)
	assert_false(Input.is_action_pressed("jump"))


func test_pass_hold_for() -> void:
	_sender.action_down("jump").hold_for(0.8)
	await wait_process_frames(2)
	assert_true(Input.is_action_pressed("jump"))
	await _sender.idle
	await wait_process_frames(2)
	assert_false(Input.is_action_pressed("jump"))


func test_pass_wait_frames() -> void:
	var start: int = Engine.get_physics_frames()
	_sender.action_down("jump").wait_frames(40).action_up("jump")
	await wait_process_frames(2)
	assert_true(Input.is_action_pressed("jump"))
	await _sender.idle
	assert_between(Engine.get_physics_frames() - start, 39, 60)


func test_pass_release_all() -> void:
	_sender.action_down("jump").key_down(KEY_A)
	await wait_process_frames(2)
	_sender.release_all()
	await wait_process_frames(2)
	assert_false(Input.is_action_pressed("jump"))
	assert_false(Input.is_key_pressed(KEY_A))


func test_pass_key() -> void:
	_sender.key_down(KEY_B)
	await wait_process_frames(2)
	assert_true(Input.is_key_pressed(KEY_B))
	_sender.key_up(KEY_B)
	await wait_process_frames(2)
	assert_false(Input.is_key_pressed(KEY_B))


func test_pass_key_by_letter() -> void:
	_sender.key_down("c")
	await wait_process_frames(2)
	assert_true(Input.is_key_pressed(KEY_C))


func test_pass_axis() -> void:
	var motion: InputEventJoypadMotion = InputEventJoypadMotion.new()
	motion.axis = JOY_AXIS_LEFT_X
	motion.axis_value = 0.5
	_sender.send_event(motion)
	await wait_process_frames(2)
	assert_almost_eq(Input.get_joy_axis(0, JOY_AXIS_LEFT_X), 0.5, 1e-6)


func test_pass_object_receives() -> void:
	var receiver: Receiver = autofree(Receiver.new())
	var sender: GutInputSender = GutInputSender.new(receiver)
	sender.action_down("jump").action_up("jump")
	assert_eq(receiver.events.size(), 2)
	assert_true(receiver.events[0].is_action("jump"))
	assert_true(receiver.events[0].is_pressed())
	assert_false(receiver.events[1].is_pressed())
