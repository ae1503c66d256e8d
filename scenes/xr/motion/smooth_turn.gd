# SPDX-License-Identifier: MIT
class_name SmoothTurn
extends Node
## Turns the visitor glidingly, as fast as the stick is pushed to a side. Makes many people sick:
## not on unless asked for.

@export var rig: XrRig
@export var hands: Array[XrHand] = []
@export_range(10.0, 180.0, 1.0, "degrees") var degrees_per_second: float = 60.0
@export var enabled: bool = false

var _rate := EasedRate.new(0.1)


func _process(delta: float) -> void:
	advance(minf(delta, 0.1))


## Lets `seconds` pass.
func advance(seconds: float) -> void:
	if not enabled:
		_rate.stop()
		return
	var asked := -Sticks.strongest(hands, rig.comfort, Sticks.Axis.X).x
	var angle := _rate.advance(Vector3(asked * deg_to_rad(degrees_per_second), 0.0, 0.0), seconds).x
	if absf(angle) > 1e-6:
		rig.turn(angle)
