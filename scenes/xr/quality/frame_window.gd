# SPDX-License-Identifier: MIT
class_name FrameWindow
extends RefCounted
## The frames of the last second, and how many of them came too late. Needs no memory of its own
## once it is made.

## More frames than a second can have.
const MOST_FRAMES: int = 1024

## So far back it reaches, seconds.
var seconds: float = 1.0

var _times: PackedFloat32Array = []
var _late: PackedByteArray = []
var _first: int = 0
var _count: int = 0
var _sum: float = 0.0
var _late_count: int = 0


func _init() -> void:
	_times.resize(MOST_FRAMES)
	_late.resize(MOST_FRAMES)


## Forgets everything.
func clear() -> void:
	_first = 0
	_count = 0
	_sum = 0.0
	_late_count = 0


## Takes note of a frame that took so long, in seconds.
func add(frame: float, is_late: bool) -> void:
	if _count == MOST_FRAMES:
		_drop()
	var at := (_first + _count) % MOST_FRAMES
	_times[at] = frame
	_late[at] = 1 if is_late else 0
	_count += 1
	_sum += frame
	_late_count += _late[at]
	while _count > 1 and _sum - _times[_first] >= seconds:
		_drop()


## Has it been filled since it was cleared?
func is_full() -> bool:
	return _sum >= seconds or _count == MOST_FRAMES


func get_count() -> int:
	return _count


## Part of the frames that came too late, 0 to 1.
func get_late_share() -> float:
	return float(_late_count) / _count if _count > 0 else 0.0


func _drop() -> void:
	_sum -= _times[_first]
	_late_count -= _late[_first]
	_first = (_first + 1) % MOST_FRAMES
	_count -= 1
