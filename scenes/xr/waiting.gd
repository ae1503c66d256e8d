# SPDX-License-Identifier: MIT
class_name Waiting
extends RefCounted
## Waits for a state, not for a number of frames: a headset has its own clock.


## Looks with every frame whether `is_so` returns true; false when it has not after `seconds`.
static func until(tree: SceneTree, is_so: Callable, seconds: float) -> bool:
	var end := Time.get_ticks_msec() + roundi(seconds * 1000.0)
	while Time.get_ticks_msec() < end:
		if is_so.call():
			return true
		await tree.process_frame
	return false
