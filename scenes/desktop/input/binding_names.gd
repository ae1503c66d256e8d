# SPDX-License-Identifier: MIT
class_name BindingNames
extends RefCounted
## Says in words which keys and gamepad controls an input action is bound to.

## What stands between two names.
const BETWEEN: String = "   "
const KEYS: Dictionary[Key, String] = {
	KEY_LEFT: "Arrow keys",
	KEY_RIGHT: "Arrow keys",
	KEY_UP: "Arrow keys",
	KEY_DOWN: "Arrow keys",
	KEY_PAGEUP: "Page Up",
	KEY_PAGEDOWN: "Page Down",
	KEY_PLUS: "+",
	KEY_MINUS: "−",
	KEY_COMMA: ",",
	KEY_PERIOD: ".",
}
## Keys that need no mention beside another key of the same action.
const SECOND_KEYS: Array[Key] = [KEY_EQUAL, KEY_KP_ADD, KEY_KP_SUBTRACT]
const BUTTONS: Dictionary[JoyButton, String] = {
	JOY_BUTTON_A: "A",
	JOY_BUTTON_B: "B",
	JOY_BUTTON_X: "X",
	JOY_BUTTON_Y: "Y",
	JOY_BUTTON_BACK: "Back",
	JOY_BUTTON_START: "Start",
	JOY_BUTTON_LEFT_STICK: "Left stick press",
	JOY_BUTTON_RIGHT_STICK: "Right stick press",
	JOY_BUTTON_LEFT_SHOULDER: "LB",
	JOY_BUTTON_RIGHT_SHOULDER: "RB",
	JOY_BUTTON_DPAD_UP: "D-pad up",
	JOY_BUTTON_DPAD_DOWN: "D-pad down",
	JOY_BUTTON_DPAD_LEFT: "D-pad left",
	JOY_BUTTON_DPAD_RIGHT: "D-pad right",
	JOY_BUTTON_MISC1: "Share",
}
const AXES: Dictionary[JoyAxis, String] = {
	JOY_AXIS_LEFT_X: "Left stick",
	JOY_AXIS_LEFT_Y: "Left stick",
	JOY_AXIS_RIGHT_X: "Right stick",
	JOY_AXIS_RIGHT_Y: "Right stick",
	JOY_AXIS_TRIGGER_LEFT: "LT",
	JOY_AXIS_TRIGGER_RIGHT: "RT",
}
const MOUSE_BUTTONS: Dictionary[MouseButton, String] = {
	MOUSE_BUTTON_MIDDLE: "Middle button",
	MOUSE_BUTTON_XBUTTON1: "Back button",
	MOUSE_BUTTON_XBUTTON2: "Forward button",
}


## The keys of the actions, each named once, in order.
static func keyboard(actions: Array[StringName]) -> String:
	var names := PackedStringArray()
	for action in actions:
		for event in InputMap.action_get_events(action):
			if event is InputEventKey and not SECOND_KEYS.has(_key_of(event as InputEventKey)):
				_add(names, of_event(event))
	return BETWEEN.join(names)


## The gamepad's sticks and buttons of the actions, each named once, in order.
static func gamepad(actions: Array[StringName]) -> String:
	var names := PackedStringArray()
	for action in actions:
		for event in InputMap.action_get_events(action):
			if event is InputEventJoypadButton or event is InputEventJoypadMotion:
				_add(names, of_event(event))
	return BETWEEN.join(names)


## The name of a key, a button or a stick; empty when it has none.
static func of_event(event: InputEvent) -> String:
	if event is InputEventKey:
		return _key_name(event as InputEventKey)
	if event is InputEventJoypadButton:
		return _translated(BUTTONS.get((event as InputEventJoypadButton).button_index, ""))
	if event is InputEventJoypadMotion:
		return _translated(AXES.get((event as InputEventJoypadMotion).axis, ""))
	if event is InputEventMouseButton:
		return _translated(MOUSE_BUTTONS.get((event as InputEventMouseButton).button_index, ""))
	return ""


static func _add(names: PackedStringArray, name: String) -> void:
	if not name.is_empty() and not names.has(name):
		names.append(name)


static func _key_name(event: InputEventKey) -> String:
	var key := _key_of(event)
	if KEYS.has(key):
		return _translated(KEYS[key])
	return _translated(OS.get_keycode_string(key))


static func _key_of(event: InputEventKey) -> Key:
	if event.keycode != KEY_NONE:
		return event.keycode
	# Not every display server knows the keyboard's layout.
	if DisplayServer.get_name() == "headless":
		return event.physical_keycode
	return DisplayServer.keyboard_get_keycode_from_physical(event.physical_keycode)


static func _translated(name: String) -> String:
	if name.is_empty():
		return ""
	return TranslationServer.translate(name)
