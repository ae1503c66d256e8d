# SPDX-License-Identifier: MIT
class_name FormulaBrackets
extends FormulaBox
## A part of a formula between brackets as tall as it is.

## Width of a bracket, of the size, and of the height as far as that is more; room inside.
const WIDTH: float = 0.24
const SHARE: float = 0.08
const GAP: float = 0.06
const STEPS: int = 12

var _inside: FormulaBox
var _style: FormulaStyle
var _bracket: float
var _is_bars: bool


## `bars`: upright lines, as round what is taken without its sign.
func _init(inside: FormulaBox, style: FormulaStyle, bars: bool) -> void:
	_inside = inside
	_style = style
	_is_bars = bars
	var reach := maxf(inside.ascent - style.axis(), inside.descent + style.axis())
	_bracket = maxf(WIDTH * style.size, SHARE * 2.0 * reach)
	width = inside.width + 2.0 * (_bracket + GAP * style.size)
	ascent = style.axis() + reach + 0.04 * style.size
	descent = reach - style.axis() + 0.04 * style.size


func draw(on: CanvasItem, at: Vector2) -> void:
	_inside.draw(on, at + Vector2(_bracket + GAP * _style.size, 0.0))
	_draw_bracket(on, at, 1.0)
	_draw_bracket(on, at + Vector2(width, 0.0), -1.0)


# From its outer end at `at`, bulging to the outside.
func _draw_bracket(on: CanvasItem, at: Vector2, inwards: float) -> void:
	var line := PackedVector2Array()
	for i in STEPS + 1:
		var share := 2.0 * i / STEPS - 1.0
		var bulge := 1.0 - share * share if not _is_bars else 0.5
		var aside := _bracket * (0.9 - 0.65 * bulge)
		var y := lerpf(-ascent, descent, 0.5 * (share + 1.0))
		line.append(at + Vector2(inwards * aside, y))
	on.draw_polyline(line, _style.colour, 1.2 * _style.line_width(), true)
