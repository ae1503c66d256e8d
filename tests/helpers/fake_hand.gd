# SPDX-License-Identifier: MIT
class_name FakeHand
extends XrHand
## A hand that a test moves, without a headset.

var here: bool = true
var stick := Vector2.ZERO
var grip: float = 0.0
## Strengths of the pulses it was given.
var pulses: PackedFloat32Array = []

var _holds: bool = false


func _init(left: bool = false) -> void:
	tracker = &"left_hand" if left else &"right_hand"


func _process(_delta: float) -> void:
	pass


func is_here() -> bool:
	return here


func get_steer() -> Vector2:
	return stick if here else Vector2.ZERO


func get_grip() -> float:
	return grip if here else 0.0


func is_choosing() -> bool:
	return _holds


func pulse(strength: float, _seconds: float = 0.03) -> void:
	pulses.append(strength)


func aim_at(place: Vector3) -> void:
	look_at(
		place,
		Vector3.UP if absf((place - global_position).normalized().y) < 0.99 else Vector3.RIGHT
	)


func press() -> void:
	_holds = true
	chosen.emit()


func release() -> void:
	_holds = false
	let_go.emit()
