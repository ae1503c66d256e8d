# SPDX-License-Identifier: MIT
## Base of the test scripts: checks, and a watch on the engine's error log.
extends RefCounted


## Collects what the engine logs as error or warning.
class LogWatch:
	extends Logger

	var messages: PackedStringArray = []
	var _mutex := Mutex.new()

	func _log_error(
		_function: String,
		_file: String,
		_line: int,
		code: String,
		rationale: String,
		_editor_notify: bool,
		_error_type: int,
		_script_backtraces: Array[ScriptBacktrace]
	) -> void:
		_mutex.lock()
		messages.append(code if rationale.is_empty() else "%s: %s" % [code, rationale])
		_mutex.unlock()


## What went wrong; empty: the test has passed.
var failures: PackedStringArray = []
## The running tree.
var tree: SceneTree
## False with upstream godot-cpp, which lets some mistakes pass that our provider refuses.
var strict := true
var _watch := LogWatch.new()


## Starts watching the error log.
func begin() -> void:
	OS.add_logger(_watch)


## Stops watching; an error that no check has asked for is a failure.
func finish() -> void:
	OS.remove_logger(_watch)
	for message: String in _watch.messages:
		failures.append("unexpected error: " + message)


## Fails unless the condition holds.
func check(condition: bool, what: String) -> void:
	if not condition:
		failures.append(what)


## Fails unless both are the same value of the same type.
func equal(got: Variant, wanted: Variant, what: String) -> void:
	if wanted == null and got == null:
		return  # nil and an empty object reference
	if typeof(got) != typeof(wanted) or got != wanted:
		failures.append("%s: got %s, wanted %s" % [what, var_to_str(got), var_to_str(wanted)])


## Fails unless the call logs an error that contains the text; returns what the call returned.
func fails(call_it: Callable, text: String, what: String) -> Variant:
	var before := _watch.messages.size()
	var returned: Variant = call_it.call()
	var seen := _watch.messages.slice(before)
	_watch.messages = _watch.messages.slice(0, before)
	for message: String in seen:
		if text.is_empty() or message.contains(text):
			return returned
	failures.append('%s: no error with "%s", but %s' % [what, text, seen])
	return returned
