# SPDX-License-Identifier: MIT
class_name PinPad
extends MenuScreen
## Asks the operator for the PIN: by keyboard, by gamepad or by mouse.

signal passed

const MOST_DIGITS: int = 12
const DELETE: String = "C"
const ENTER: String = "OK"
const KEYS: PackedStringArray = ["1", "2", "3", "4", "5", "6", "7", "8", "9", DELETE, "0", ENTER]

var pin := OperatorPin.new()

var _digits: String
var _first: Button

@onready var _shown: Label = %Digits
@onready var _note: Label = %Note
@onready var _keys: GridContainer = %Keys


func _ready() -> void:
	for key in KEYS:
		var button := Button.new()
		button.text = key
		button.auto_translate_mode = Node.AUTO_TRANSLATE_MODE_DISABLED
		button.custom_minimum_size = Vector2(84.0, 60.0)
		button.add_theme_font_size_override(&"font_size", 24)
		button.pressed.connect(press.bind(key))
		_keys.add_child(button)
		if key == "5":
			_first = button


func _process(_delta: float) -> void:
	if visible:
		_tell()


func _input(event: InputEvent) -> void:
	var key := event as InputEventKey
	if not visible or key == null or not key.pressed:
		return
	var digit := char(key.unicode) if key.unicode >= 48 and key.unicode < 58 else ""
	if key.keycode == KEY_BACKSPACE:
		digit = DELETE
	elif key.keycode == KEY_KP_ENTER:
		digit = ENTER
	if not digit.is_empty():
		get_viewport().set_input_as_handled()
		press(digit)


func get_first_focus() -> Control:
	return _first


## As if a key of the pad were pressed.
func press(key: String) -> void:
	if key == DELETE:
		_digits = _digits.left(-1)
	elif key == ENTER:
		_try()
	elif _digits.length() < MOST_DIGITS:
		_digits += key
	_tell()


func _on_open() -> void:
	_digits = ""
	_tell()


func _try() -> void:
	var right := pin.accepts(_digits, _now())
	_digits = ""
	if right:
		close()
		passed.emit()


func _tell() -> void:
	_shown.text = "•".repeat(_digits.length())
	var wait := pin.get_wait(_now())
	_note.text = tr("Wrong PIN. Next try in %d s.") % ceili(wait) if wait > 0.0 else ""


func _now() -> float:
	return Time.get_ticks_msec() * 1e-3
