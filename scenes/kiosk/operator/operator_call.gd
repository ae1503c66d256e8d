# SPDX-License-Identifier: MIT
class_name OperatorCall
extends Node
## Hears when the operator asks for the panel: a key, or Back and Start held together on a gamepad.
## Must stand after the visitors' presence in the scene, so that it hears the input first.

signal asked

const HOLD_SECONDS: float = 3.0

var _keycode: Key = KEY_NONE
var _held: float = 0.0


func _ready() -> void:
	process_mode = Node.PROCESS_MODE_ALWAYS


func _process(delta: float) -> void:
	if not _are_held():
		_held = 0.0
	elif _held < HOLD_SECONDS:
		_held += delta
		if _held >= HOLD_SECONDS:
			asked.emit()


func _input(event: InputEvent) -> void:
	var key := event as InputEventKey
	if key == null or not key.pressed or key.echo or _keycode == KEY_NONE:
		return
	if key.get_keycode_with_modifiers() == _keycode:
		get_viewport().set_input_as_handled()
		asked.emit()


## Takes a key such as "Ctrl+Shift+F12".
func set_hotkey(hotkey: String) -> void:
	_keycode = OS.find_keycode_from_string(hotkey)


func _are_held() -> bool:
	for device in Input.get_connected_joypads():
		if (
			Input.is_joy_button_pressed(device, JOY_BUTTON_BACK)
			and Input.is_joy_button_pressed(device, JOY_BUTTON_START)
		):
			return true
	return false
