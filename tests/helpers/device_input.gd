# SPDX-License-Identifier: MIT
class_name DeviceInput
extends RefCounted
## Events as keyboard and gamepad send them.


static func key(which: Key, pressed: bool = true) -> InputEventKey:
	var event := InputEventKey.new()
	event.physical_keycode = which
	event.keycode = which
	event.pressed = pressed
	return event


static func button(which: JoyButton, pressed: bool = true) -> InputEventJoypadButton:
	var event := InputEventJoypadButton.new()
	event.button_index = which
	event.pressed = pressed
	return event


## By way of the polled state of the input, which tabs and sliders ask as well.
static func send(event: InputEvent) -> void:
	Input.parse_input_event(event)
	Input.flush_buffered_events()


## Sends a press of this key or button, and its release.
static func press(event: InputEvent) -> void:
	for pressed: bool in [true, false]:
		var sent := event.duplicate() as InputEvent
		sent.set(&"pressed", pressed)
		send(sent)
