# SPDX-License-Identifier: MIT
class_name HeadsetPresence
extends RefCounted
## Whether a headset sits on a head. Where it has no sensor for that, it tells by its stillness: no
## living head holds quite still.

## Moving less than so much is lying: metres, and radians.
const STEP: float = 0.002
const TURN: float = 0.004
## It lies when it has not moved for so long, seconds.
const STILL_SECONDS: float = 6.0
## And sits on a head when it has moved for so long, without a longer rest than this, seconds.
const MOVING_SECONDS: float = 1.5
const REST_SECONDS: float = 0.6

var _last := Transform3D.IDENTITY
var _still: float = STILL_SECONDS
var _moving: float = 0.0
var _is_worn: bool = false


## Takes note of where it is, `seconds` after the last time; `focused`: the runtime says that
## somebody looks. Returns whether it is worn.
func see(focused: bool, pose: Transform3D, seconds: float) -> bool:
	var moved := pose.origin.distance_to(_last.origin) > STEP or _turned(pose) > TURN
	if moved:
		_last = pose
		_still = 0.0
	else:
		_still += seconds
	_moving = _moving + seconds if _still < REST_SECONDS else 0.0
	if not focused or _still >= STILL_SECONDS:
		_is_worn = false
	elif _moving >= MOVING_SECONDS:
		_is_worn = true
	return _is_worn


func _turned(pose: Transform3D) -> float:
	return (pose.basis.z.normalized() - _last.basis.z.normalized()).length()
