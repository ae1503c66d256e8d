# SPDX-License-Identifier: MIT
class_name EasedRate
extends RefCounted
## A rate of motion that follows what is asked of it with a short delay, as if it had some weight.
##
## The rate obeys rate' = (target - rate) / settling_time. Its integral over a step is taken
## exactly, so the way covered does not depend on how the time is cut into frames.

## Seconds after which 63 % of a change is made.
var settling_time: float

var _rate := Vector3.ZERO


func _init(seconds: float) -> void:
	settling_time = seconds


func get_rate() -> Vector3:
	return _rate


## Lets `seconds` pass with the given target and returns the way covered.
func advance(target: Vector3, seconds: float) -> Vector3:
	var kept := exp(-seconds / settling_time)
	var lag := _rate - target
	_rate = target + lag * kept
	return target * seconds + lag * (settling_time * (1.0 - kept))


func stop() -> void:
	_rate = Vector3.ZERO
