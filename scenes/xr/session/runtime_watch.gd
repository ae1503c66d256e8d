# SPDX-License-Identifier: MIT
class_name RuntimeWatch
extends RefCounted
## Notices that the headset's runtime has died where the engine says nothing about it: frames then
## follow each other far faster than the headset shows them, and the head stands perfectly still.

## Frames in a row that came too early.
const FRAMES: int = 12
## And for so long, seconds.
const SECONDS: float = 0.15
## A frame is too early when it comes within this part of a picture's time.
const EARLY: float = 0.4
## Pictures a second where the headset does not tell: the slowest that there are show 60, but
## software that stands for a headset may show 20.
const LEAST_RATE: float = 20.0

var _last_usec: int = 0
var _early_frames: int = 0
var _early_seconds: float = 0.0
var _last_pose := Transform3D.IDENTITY


## Forgets what was seen.
func reset() -> void:
	_last_usec = 0
	_early_frames = 0
	_early_seconds = 0.0


## Takes note of a frame at this time, with the head there; `rate`: pictures a second, 0 if unknown.
func see_frame(now_usec: int, pose: Transform3D, rate: float) -> void:
	var period := 1.0 / (rate if rate > 0.0 else LEAST_RATE)
	var frame := (now_usec - _last_usec) * 1e-6
	var first := _last_usec == 0
	_last_usec = now_usec
	var still := pose == _last_pose
	_last_pose = pose
	if first or frame > EARLY * period or not still:
		_early_frames = 0
		_early_seconds = 0.0
		return
	_early_frames += 1
	_early_seconds += frame


func is_dead() -> bool:
	return _early_frames >= FRAMES and _early_seconds >= SECONDS
