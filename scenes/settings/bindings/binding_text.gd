# SPDX-License-Identifier: MIT
class_name BindingText
extends RefCounted
## Keys, buttons and sticks as words for a file: "key:W" is the key at the place of W, "sign:Plus"
## the one that types a plus, "pad:a" a button, "axis:left_x+" a stick, "mouse:middle" a button.

const KEY: String = "key"
const SIGN: String = "sign"
const PAD: String = "pad"
const AXIS: String = "axis"
const MOUSE: String = "mouse"
const ANY_DEVICE: int = -1

const BUTTONS: Dictionary[JoyButton, String] = {
	JOY_BUTTON_A: "a",
	JOY_BUTTON_B: "b",
	JOY_BUTTON_X: "x",
	JOY_BUTTON_Y: "y",
	JOY_BUTTON_BACK: "back",
	JOY_BUTTON_START: "start",
	JOY_BUTTON_LEFT_STICK: "left_stick",
	JOY_BUTTON_RIGHT_STICK: "right_stick",
	JOY_BUTTON_LEFT_SHOULDER: "left_shoulder",
	JOY_BUTTON_RIGHT_SHOULDER: "right_shoulder",
	JOY_BUTTON_DPAD_UP: "up",
	JOY_BUTTON_DPAD_DOWN: "down",
	JOY_BUTTON_DPAD_LEFT: "left",
	JOY_BUTTON_DPAD_RIGHT: "right",
	JOY_BUTTON_MISC1: "share",
}
const AXES: Dictionary[JoyAxis, String] = {
	JOY_AXIS_LEFT_X: "left_x",
	JOY_AXIS_LEFT_Y: "left_y",
	JOY_AXIS_RIGHT_X: "right_x",
	JOY_AXIS_RIGHT_Y: "right_y",
	JOY_AXIS_TRIGGER_LEFT: "left_trigger",
	JOY_AXIS_TRIGGER_RIGHT: "right_trigger",
}
## Left, right and wheel are the view's own.
const MOUSE_BUTTONS: Dictionary[MouseButton, String] = {
	MOUSE_BUTTON_MIDDLE: "middle",
	MOUSE_BUTTON_XBUTTON1: "back",
	MOUSE_BUTTON_XBUTTON2: "forward",
}


## The words for an event; empty for one that nothing can be bound to.
static func of(event: InputEvent) -> String:
	if event is InputEventKey:
		return _of_key(event as InputEventKey)
	if event is InputEventJoypadButton:
		return _joined(PAD, BUTTONS.get((event as InputEventJoypadButton).button_index, ""))
	if event is InputEventJoypadMotion:
		var motion := event as InputEventJoypadMotion
		if AXES.has(motion.axis):
			return _joined(AXIS, AXES[motion.axis] + ("+" if motion.axis_value > 0.0 else "-"))
	elif event is InputEventMouseButton:
		return _joined(MOUSE, MOUSE_BUTTONS.get((event as InputEventMouseButton).button_index, ""))
	return ""


## The event that the words mean, of any keyboard or gamepad; null when they mean none.
static func to_event(words: String) -> InputEvent:
	var name := words.substr(words.find(":") + 1)
	var event: InputEvent = null
	match words.get_slice(":", 0):
		KEY, SIGN:
			event = _to_key(name, words.begins_with(SIGN))
		PAD:
			if BUTTONS.values().has(name):
				var button := InputEventJoypadButton.new()
				button.button_index = BUTTONS.find_key(name)
				event = button
		AXIS:
			if AXES.values().has(name.left(-1)) and "+-".contains(name.right(1)):
				var motion := InputEventJoypadMotion.new()
				motion.axis = AXES.find_key(name.left(-1))
				motion.axis_value = 1.0 if name.ends_with("+") else -1.0
				event = motion
		MOUSE:
			if MOUSE_BUTTONS.values().has(name):
				var click := InputEventMouseButton.new()
				click.button_index = MOUSE_BUTTONS.find_key(name)
				event = click
	if event != null:
		event.device = ANY_DEVICE
	return event


static func _joined(kind: String, name: String) -> String:
	return "" if name.is_empty() else kind + ":" + name


static func _of_key(event: InputEventKey) -> String:
	if event.physical_keycode != KEY_NONE:
		return _joined(KEY, OS.get_keycode_string(event.physical_keycode))
	return _joined(SIGN, OS.get_keycode_string(event.keycode))


static func _to_key(name: String, is_sign: bool) -> InputEvent:
	var key := OS.find_keycode_from_string(name)
	if key == KEY_NONE:
		return null
	var event := InputEventKey.new()
	if is_sign:
		event.keycode = key
	else:
		event.physical_keycode = key
	return event
