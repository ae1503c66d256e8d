# SPDX-License-Identifier: MIT
class_name EasedRemainder
extends RefCounted
## A way still to go, given in jerks (mouse movements, wheel notches), covered smoothly.
##
## Each second a fixed share of what is left is covered, independently of the frame rate.

## Seconds after which 63 % of the way is covered.
var settling_time: float

var _left := Vector3.ZERO


func _init(seconds: float) -> void:
	settling_time = seconds


func get_left() -> Vector3:
	return _left


func add(way: Vector3) -> void:
	if way.is_finite():
		_left += way


## Lets `seconds` pass and returns the way covered.
func advance(seconds: float) -> Vector3:
	var covered := _left * (1.0 - exp(-seconds / settling_time))
	_left -= covered
	return covered


func stop() -> void:
	_left = Vector3.ZERO
