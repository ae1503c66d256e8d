# SPDX-License-Identifier: MIT
class_name FloatingWords
extends FlatPicture
## Some words on a dark plate in the world, as large as they need.

## Height of an em in the picture, pixels, and the longest line in ems.
const EM: int = 48
const LONGEST_LINE: float = 18.0
const PADDING := Vector2i(28, 16)

@export var colour: Color = MenuLook.TEXT

var _plate := Panel.new()
var _label := Label.new()


func _init() -> void:
	super()
	var box := MenuLook.box(MenuLook.PANEL, MenuLook.RIM)
	box.set_corner_radius_all(18)
	box.set_border_width_all(2)
	_plate.add_theme_stylebox_override(&"panel", box)
	_label.horizontal_alignment = HORIZONTAL_ALIGNMENT_CENTER
	_label.vertical_alignment = VERTICAL_ALIGNMENT_CENTER
	# Else it would want to be as high as its words are in the width that it had before.
	_label.clip_text = true
	_label.autowrap_mode = TextServer.AUTOWRAP_WORD_SMART
	_label.add_theme_font_size_override(&"font_size", EM)
	_plate.add_child(_label)
	viewport.add_child(_plate)


func get_words() -> String:
	return _label.text


## Shows `words` with an em of so many metres.
func set_words(words: String, em_metres: float) -> void:
	_label.text = words
	_label.add_theme_color_override(&"font_color", colour)
	var font := _label.get_theme_font(&"font")
	var size := font.get_multiline_string_size(
		words, HORIZONTAL_ALIGNMENT_CENTER, EM * LONGEST_LINE, EM
	)
	pixels = Vector2i(size.ceil()) + 2 * PADDING
	_plate.size = pixels
	_label.position = PADDING
	_label.size = size.ceil()
	width = em_metres * pixels.x / EM
	redraw()
