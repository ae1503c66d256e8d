# SPDX-License-Identifier: MIT
class_name FormulaFraction
extends FormulaBox
## A part of a formula over another, with a bar between them.

## Of the size: how far the bar stands out, what is between it and the parts, and what is beside it.
const OVERHANG: float = 0.12
const GAP: float = 0.14
const BESIDE: float = 0.1

var _above: FormulaBox
var _below: FormulaBox
var _style: FormulaStyle
var _bar: float


func _init(above: FormulaBox, below: FormulaBox, style: FormulaStyle) -> void:
	_above = above
	_below = below
	_style = style
	_bar = maxf(above.width, below.width) + 2.0 * OVERHANG * style.size
	width = _bar + 2.0 * BESIDE * style.size
	ascent = style.axis() + GAP * style.size + above.get_height()
	descent = GAP * style.size + below.get_height() - style.axis()


func draw(on: CanvasItem, at: Vector2) -> void:
	var left := at.x + BESIDE * _style.size
	var line := at.y - _style.axis()
	var gap := GAP * _style.size
	on.draw_line(
		Vector2(left, line), Vector2(left + _bar, line), _style.colour, _style.line_width(), true
	)
	var above := Vector2(left + 0.5 * (_bar - _above.width), line - gap - _above.descent)
	var below := Vector2(left + 0.5 * (_bar - _below.width), line + gap + _below.ascent)
	_above.draw(on, above)
	_below.draw(on, below)
