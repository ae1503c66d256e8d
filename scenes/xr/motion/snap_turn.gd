# SPDX-License-Identifier: MIT
class_name SnapTurn
extends Node
## Turns the visitor in steps: one for each push of the stick to a side.

## The visitor has been turned, radians to the left.
signal turned(angle: float)

## The stick counts as pushed from here on, and as let go below.
const PUSHED: float = 0.7
const LET_GO: float = 0.35

@export var rig: XrRig
@export var hands: Array[XrHand] = []
@export_range(5.0, 90.0, 1.0, "degrees") var step_degrees: float = 30.0
@export var enabled: bool = true

var _is_pushed: bool = false


func _process(_delta: float) -> void:
	if not enabled:
		return
	var stick := Sticks.strongest(hands, rig.comfort, Sticks.Axis.X)
	if absf(stick.x) < LET_GO:
		_is_pushed = false
	elif not _is_pushed and absf(stick.x) >= PUSHED and absf(stick.x) > absf(stick.y):
		_is_pushed = true
		var angle := -signf(stick.x) * deg_to_rad(step_degrees)
		rig.snap(angle)
		turned.emit(angle)
