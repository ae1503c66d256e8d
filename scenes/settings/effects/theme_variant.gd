# SPDX-License-Identifier: MIT
class_name ThemeVariant
extends RefCounted
## Makes the text of a theme larger and its panels plainer, and back again.

const TEXT := Color.WHITE
const FAINT_TEXT := Color(0.75, 0.75, 0.75)
const GROUND := Color.BLACK
const BORDER := Color(1.0, 1.0, 1.0, 0.85)
const FOCUS := Color(1.0, 0.85, 0.2)
## Text in these colours says something by its colour.
const MEANING_BY_COLOUR: PackedStringArray = ["Warning"]

var _theme: Theme
var _given: Theme


func _init(theme: Theme) -> void:
	_theme = theme
	_given = theme.duplicate(true)


## Shows the theme with text so many times as large, and with high contrast or not.
func apply(text_factor: float, contrast: bool) -> void:
	_theme.default_font_size = roundi(_given.default_font_size * text_factor)
	for type in _given.get_font_size_type_list():
		for name in _given.get_font_size_list(type):
			var pixels := _given.get_font_size(name, type)
			_theme.set_font_size(name, type, roundi(pixels * text_factor))
	for type in _given.get_color_type_list():
		for name in _given.get_color_list(type):
			var colour := _given.get_color(name, type)
			_theme.set_color(name, type, _plain_text(name, type, colour) if contrast else colour)
	for type in _given.get_stylebox_type_list():
		for name in _given.get_stylebox_list(type):
			var box := _given.get_stylebox(name, type)
			_theme.set_stylebox(name, type, _plain_box(box) if contrast else box)


func _plain_text(name: String, type: String, colour: Color) -> Color:
	if not name.begins_with("font_") or MEANING_BY_COLOUR.has(type):
		return colour
	if name.contains("shadow") or name.contains("outline"):
		return colour
	return FAINT_TEXT if name.contains("disabled") else TEXT


func _plain_box(box: StyleBox) -> StyleBox:
	if not box is StyleBoxFlat:
		return box
	var plain := box.duplicate() as StyleBoxFlat
	if not plain.draw_center:
		plain.border_color = FOCUS
		plain.set_border_width_all(3)
	elif plain.bg_color.a > 0.5:
		plain.bg_color = GROUND
		plain.border_color = BORDER
		plain.set_border_width_all(2)
	else:
		plain.bg_color = Color(plain.bg_color, minf(2.0 * plain.bg_color.a, 0.5))
		plain.border_color = BORDER
		plain.set_border_width_all(1)
	return plain
