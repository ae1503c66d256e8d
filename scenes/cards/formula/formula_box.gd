# SPDX-License-Identifier: MIT
class_name FormulaBox
extends RefCounted
## A part of a formula with its extent round the base line, in pixels.

var width: float = 0.0
## Above the base line and below it, both positive.
var ascent: float = 0.0
var descent: float = 0.0
## How far its upper end leans over to the right.
var lean: float = 0.0


func get_height() -> float:
	return ascent + descent


## Draws it with its left end of the base line at `at`.
func draw(_on: CanvasItem, _at: Vector2) -> void:
	pass
