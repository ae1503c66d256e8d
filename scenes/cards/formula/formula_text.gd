# SPDX-License-Identifier: MIT
class_name FormulaText
extends FormulaBox
## Letters, digits or a sign.

## What letters take of the size over and under the base line.
const ASCENT: float = 0.75
const DESCENT: float = 0.22
## How far slanted letters lean over, of the size.
const LEAN: float = 0.1

var text: String

var _font: Font
var _style: FormulaStyle
## To the left of the text; signs have it to both sides.
var _space: float


func _init(letters: String, style: FormulaStyle, is_slanted: bool, space: float = 0.0) -> void:
	text = letters
	_style = style
	_font = style.slanted if is_slanted else style.upright
	_space = space * style.size
	var extent := _font.get_string_size(text, HORIZONTAL_ALIGNMENT_LEFT, -1.0, style.size)
	width = extent.x + 2.0 * _space
	if is_slanted:
		lean = LEAN * style.size
		width += 0.5 * lean
	ascent = ASCENT * style.size
	descent = DESCENT * style.size


func draw(on: CanvasItem, at: Vector2) -> void:
	var left := at + Vector2(_space, 0.0)
	on.draw_string(_font, left, text, HORIZONTAL_ALIGNMENT_LEFT, -1.0, _style.size, _style.colour)
