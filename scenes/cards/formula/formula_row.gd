# SPDX-License-Identifier: MIT
class_name FormulaRow
extends FormulaBox
## Parts of a formula one after the other on one base line.

var parts: Array[FormulaBox] = []


func add(part: FormulaBox) -> void:
	parts.append(part)
	width += part.width
	ascent = maxf(ascent, part.ascent)
	descent = maxf(descent, part.descent)


## Takes the last part out; null where there is none.
func take_last() -> FormulaBox:
	var last: FormulaBox = parts.pop_back()
	if last == null:
		return null
	var others := parts.duplicate()
	parts.clear()
	width = 0.0
	ascent = 0.0
	descent = 0.0
	for other: FormulaBox in others:
		add(other)
	return last


func draw(on: CanvasItem, at: Vector2) -> void:
	var left := at
	for part in parts:
		part.draw(on, left)
		left.x += part.width
