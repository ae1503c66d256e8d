# SPDX-License-Identifier: MIT
extends "layer_signals.gd"
## Asserts on errors. Every error that a test does not deal with fails it.


## The errors and warnings of the test so far. Set `handled` of those that were expected.
func get_errors() -> Array:
	return gut.error_tracker.get_errors()


## One push_error with this text in it happened; upper and lower case are the same. Deals with it.
func assert_push_error(text: Variant, msg: Variant = "") -> void:
	_assert_one("push_error", str(text), msg)


## So many calls of push_error happened. Deals with them.
func assert_push_error_count(count: int, msg: String = "") -> void:
	_assert_count("push_error", count, msg)


## Like assert_push_error, for errors and warnings of the engine and of scripts.
func assert_engine_error(text: Variant, msg: Variant = "") -> void:
	_assert_one("engine", str(text), msg)


func assert_engine_error_count(count: int, msg: String = "") -> void:
	_assert_count("engine", count, msg)


## Like assert_push_error, for push_warning, which by itself fails no test.
func assert_push_warning(text: String, msg: String = "") -> void:
	_assert_one("push_warning", text, msg)


func assert_push_warning_count(count: int, msg: String = "") -> void:
	_assert_count("push_warning", count, msg)


func _assert_one(type: String, text: String, note: Variant) -> void:
	if not _are_tracked(note):
		return
	for error: GutTrackedError in _open_errors(type):
		if not text.is_empty() and error.contains_text(text):
			error.handled = true
			_pass()
			return
	_check(false, "expected a " + type + " error with {0} in it", [text], note)


func _assert_count(type: String, count: int, note: String) -> void:
	if not _are_tracked(note):
		return
	var open: Array[GutTrackedError] = _open_errors(type)
	if open.size() == count:
		for error: GutTrackedError in open:
			error.handled = true
	var message: String = "expected {0} errors of type " + type + ", got {1}"
	_check(open.size() == count, message, [count, open.size()], note)


func _open_errors(type: String) -> Array[GutTrackedError]:
	var open: Array[GutTrackedError] = []
	for error: GutTrackedError in gut.error_tracker.get_errors():
		if not error.handled and error.get_error_type_name() == type:
			open.append(error)
	return open


func _are_tracked(note: Variant) -> bool:
	if not gut.tracks_errors:
		_check(false, "errors are not tracked in this run", [], note)
	return gut.tracks_errors
