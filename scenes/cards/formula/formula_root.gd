# SPDX-License-Identifier: MIT
class_name FormulaRoot
extends FormulaBox
## A part of a formula under a root.

## Of the size: width of the hook, room under the line, and what is beside the root.
const HOOK: float = 0.55
const GAP: float = 0.12
const BESIDE: float = 0.06

var _inside: FormulaBox
var _style: FormulaStyle


func _init(inside: FormulaBox, style: FormulaStyle) -> void:
	_inside = inside
	_style = style
	width = inside.width + (HOOK + 2.0 * BESIDE) * style.size
	ascent = inside.ascent + GAP * style.size + style.line_width()
	descent = inside.descent


func draw(on: CanvasItem, at: Vector2) -> void:
	var pixels := float(_style.size)
	var left := at + Vector2(BESIDE * pixels, 0.0)
	var top := at.y - ascent + 0.5 * _style.line_width()
	var bottom := at.y + descent
	var middle := lerpf(bottom, top, 0.45)
	var right := left.x + HOOK * pixels
	var hook := PackedVector2Array(
		[
			Vector2(left.x, middle + 0.06 * pixels),
			Vector2(left.x + 0.12 * pixels, middle),
			Vector2(left.x + 0.28 * pixels, bottom),
			Vector2(right - 0.04 * pixels, top),
			Vector2(right + _inside.width, top),
		]
	)
	on.draw_polyline(hook, _style.colour, _style.line_width(), true)
	_inside.draw(on, Vector2(right, at.y))
