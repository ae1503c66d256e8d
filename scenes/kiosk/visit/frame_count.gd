# SPDX-License-Identifier: MIT
class_name FrameCount
extends RefCounted
## Counts pictures: how many come in a second, the fewest there were, and how many came late.

## A picture is late when it takes longer than so many of the screen's or the headset's.
const LATE_FROM: float = 1.5

## Pictures in the last full second, and the fewest; 0: no second is over yet.
var fps: int = 0
var least_fps: int = 0
var late: int = 0

var _frames: int = 0
var _seconds: float = 0.0


func clear() -> void:
	least_fps = 0
	late = 0
	_frames = 0
	_seconds = 0.0


## A picture that took `seconds`, where one should take `period`; 0: unknown.
func add(seconds: float, period: float) -> void:
	_frames += 1
	_seconds += seconds
	if period > 0.0 and seconds > LATE_FROM * period:
		late += 1
	if _seconds >= 1.0:
		fps = roundi(_frames / _seconds)
		least_fps = fps if least_fps == 0 else mini(least_fps, fps)
		_frames = 0
		_seconds = 0.0
