# SPDX-License-Identifier: MIT
class_name SimulatedHand
extends RefCounted
## A controller of the simulated headset: where it is and what is pressed.

const BYTES: int = 120

## In the room, metres.
var pose := Transform3D.IDENTITY
var trigger: float = 0.0
var grip: float = 0.0
var stick := Vector2.ZERO
var button_a: bool = false
var button_b: bool = false
## Switched on and in sight.
var active: bool = true


func _init(place: Vector3) -> void:
	pose.origin = place


## As the runtime's remote driver reads it.
func write(into: PackedByteArray, at: int) -> void:
	SimulatedHeadset.write_pose(into, at, pose)
	# Velocities (24 bytes) and the fingers' bend (20 bytes) stay 0.
	into.encode_float(at + 72, trigger)
	into.encode_float(at + 76, grip)
	into.encode_float(at + 80, grip)
	into.encode_float(at + 84, stick.x)
	into.encode_float(at + 88, stick.y)
	# Of the trackpad nothing (12 bytes).
	var pressed: Array[bool] = [
		false,
		active,
		false,
		false,
		button_a,
		button_a,
		button_b,
		button_b,
		trigger > 0.9,
		trigger > 0.0,
		false,
		stick != Vector2.ZERO,
		false
	]
	for i in pressed.size():
		into[at + 104 + i] = 1 if pressed[i] else 0
