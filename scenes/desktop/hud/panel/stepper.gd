# SPDX-License-Identifier: MIT
class_name Stepper
extends Button
## Chooses one of a few things by name: left and right go through them, a press goes on, and round
## again after the last.

## Another one was chosen.
signal chosen(at: int)

## Not narrower than this, in pixels, so that several below each other look alike.
const LEAST_WIDTH: float = 196.0

## Their names, translated.
var titles := PackedStringArray():
	set(value):
		if titles != value:
			titles = value
			_keep_room()
		_show()
## Which of them is chosen, from 0. Setting it does not emit [signal chosen].
var at: int = 0:
	set(value):
		at = value
		_show()


func _init() -> void:
	theme_type_variation = &"SmallButton"
	auto_translate_mode = Node.AUTO_TRANSLATE_MODE_DISABLED


func _gui_input(event: InputEvent) -> void:
	var click := event as InputEventMouseButton
	if _begins(&"ui_left", event):
		_step(-1)
	elif _begins(&"ui_right", event) or event.is_action_pressed(&"ui_accept"):
		_step(1)
	elif click != null and click.pressed and click.button_index == MOUSE_BUTTON_LEFT:
		_step(-1 if click.position.x < 0.3 * size.x else 1)


# A stick sends many events on its way; the first that counts is the press.
func _begins(action: StringName, event: InputEvent) -> bool:
	if event is InputEventJoypadMotion:
		return Input.is_action_just_pressed_by_event(action, event)
	return event.is_action_pressed(action, true)


func _step(by: int) -> void:
	accept_event()
	if not titles.is_empty():
		at = posmod(at + by, titles.size())
		chosen.emit(at)


func _show() -> void:
	text = _framed(titles[at]) if at >= 0 and at < titles.size() else ""


# So that its width does not jump from one to the next.
func _keep_room() -> void:
	var font := get_theme_font(&"font")
	var pixels := get_theme_font_size(&"font_size")
	var widest := LEAST_WIDTH - get_theme_stylebox(&"normal").get_minimum_size().x
	for title in titles:
		var extent := font.get_string_size(_framed(title), HORIZONTAL_ALIGNMENT_LEFT, -1.0, pixels)
		widest = maxf(widest, extent.x)
	custom_minimum_size.x = ceilf(widest + get_theme_stylebox(&"normal").get_minimum_size().x)


func _framed(title: String) -> String:
	return "‹  %s  ›" % title
