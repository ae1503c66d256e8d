# SPDX-License-Identifier: MIT
class_name FormulaScripts
extends FormulaBox
## A part of a formula with what stands raised or lowered to its right.

## Of the size: how far scripts of a letter move, the gap to them, and how far a tall part's move
## over its ends.
const RAISE: float = 0.36
const LOWER: float = 0.2
const GAP: float = 0.04
const OVERLAP: float = 0.45

var _base: FormulaBox
var _raised: FormulaBox
var _lowered: FormulaBox
var _gap: float
var _up: float
var _down: float


## `raised` and `lowered` may be null.
func _init(base: FormulaBox, raised: FormulaBox, lowered: FormulaBox, style: FormulaStyle) -> void:
	_base = base
	_raised = raised
	_lowered = lowered
	_gap = GAP * style.size
	ascent = base.ascent
	descent = base.descent
	var beside := 0.0
	if raised != null:
		_up = maxf(RAISE * style.size, base.ascent - OVERLAP * raised.get_height())
		ascent = maxf(ascent, _up + raised.ascent)
		beside = raised.width
	if lowered != null:
		_down = maxf(LOWER * style.size, base.descent - OVERLAP * lowered.get_height())
		descent = maxf(descent, _down + lowered.descent)
		beside = maxf(beside, lowered.width - base.lean)
	width = base.width + _gap + beside


func draw(on: CanvasItem, at: Vector2) -> void:
	_base.draw(on, at)
	var right := at.x + _base.width + _gap
	if _raised != null:
		_raised.draw(on, Vector2(right, at.y - _up))
	if _lowered != null:
		_lowered.draw(on, Vector2(right - _base.lean, at.y + _down))
