# SPDX-License-Identifier: MIT
extends "layer_errors.gd"
## Waiting within a test. Each must be awaited.

var _timed_out: bool = false


func wait_seconds(time: Variant, msg: Variant = "") -> void:
	_note("%s s" % time, msg)
	await get_tree().create_timer(time).timeout


## Waits until so many frames have begun.
func wait_process_frames(x: int, msg: Variant = "") -> void:
	_note("%d frames" % x, msg)
	for i: int in x:
		await get_tree().process_frame


## Another name of wait_process_frames.
func wait_idle_frames(x: int, msg: Variant = "") -> void:
	await wait_process_frames(x, msg)


func wait_physics_frames(x: int, msg: Variant = "") -> void:
	_note("%d physics frames" % x, msg)
	for i: int in x:
		await get_tree().physics_frame


## Waits for a signal, at most max_time seconds, and watches its object. Returns whether it came.
func wait_for_signal(sig: Signal, max_time: Variant, msg: Variant = "") -> Variant:
	watch_signals(sig.get_object())
	# An array, since a lambda gets copies of plain variables.
	var came: Array[bool] = [false]
	var note: Callable = func(..._args: Array) -> void: came[0] = true
	sig.connect(note)
	_note("signal %s" % sig.get_name(), msg)
	await _wait(func() -> bool: return came[0], max_time, 0.0)
	if not sig.is_null() and sig.is_connected(note):
		sig.disconnect(note)
	return not _timed_out


## Waits until the callable returns exactly true, at most max_time seconds. The optional third
## argument is the time between two calls in seconds; without it there is one call per frame.
## Returns whether it did.
func wait_until(
	callable: Variant, max_time: Variant, p3: Variant = "", p4: Variant = ""
) -> Variant:
	return await _wait_for_value(callable, true, max_time, p3, p4)


## Waits while the callable returns exactly true. Returns whether that ended in time.
func wait_while(
	callable: Variant, max_time: Variant, p3: Variant = "", p4: Variant = ""
) -> Variant:
	return await _wait_for_value(callable, false, max_time, p3, p4)


## Whether the last wait with a time limit reached that limit.
func did_wait_timeout() -> Variant:
	return _timed_out


func _wait_for_value(
	callable: Callable, value: bool, max_time: float, p3: Variant, p4: Variant
) -> bool:
	var between: float = 0.0 if p3 is String else float(p3)
	_note("at most %s s" % max_time, p3 if p3 is String else p4)
	var condition: Callable = func() -> bool: return is_same(callable.call(), true) == value
	await _wait(condition, max_time, between)
	return not _timed_out


## Waits until a condition holds. Time is the time of the frames, so that a fixed frame rate counts.
func _wait(condition: Callable, max_time: float, between: float) -> void:
	_timed_out = false
	var waited: float = 0.0
	var since_call: float = 0.0
	while true:
		await get_tree().process_frame
		var delta: float = get_process_delta_time()
		waited += delta
		since_call += delta
		if since_call >= between:
			since_call = 0.0
			if condition.call():
				return
		if waited >= max_time:
			_timed_out = true
			return


func _note(what: String, msg: Variant) -> void:
	gut.note_wait("waits for %s %s" % [what, msg])
