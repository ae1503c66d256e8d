# SPDX-License-Identifier: MIT
extends Logger
## Collects what the engine's log receives. Called from any thread.

var _mutex: Mutex = Mutex.new()
var _errors: Array[GutTrackedError] = []


## Forgets everything collected so far.
func clear() -> void:
	_mutex.lock()
	_errors = []
	_mutex.unlock()


## The errors and warnings since the last clear(), oldest first.
func get_errors() -> Array[GutTrackedError]:
	_mutex.lock()
	var copy: Array[GutTrackedError] = _errors.duplicate()
	_mutex.unlock()
	return copy


## The errors that fail a test: of one of the named types ("engine", "push_error") and not handled.
func get_unhandled(failing_types: PackedStringArray) -> Array[GutTrackedError]:
	var unhandled: Array[GutTrackedError] = []
	for error: GutTrackedError in get_errors():
		if not error.handled and error.get_error_type_name() in failing_types:
			unhandled.append(error)
	return unhandled


func _log_error(
	function: String,
	file: String,
	line: int,
	code: String,
	rationale: String,
	_editor_notify: bool,
	error_type: int,
	script_backtraces: Array[ScriptBacktrace]
) -> void:
	var error: GutTrackedError = GutTrackedError.new()
	error.function = function
	error.file = file
	error.line = line
	error.code = code
	error.rationale = rationale
	error.error_type = error_type
	error.backtrace = script_backtraces
	_mutex.lock()
	_errors.append(error)
	_mutex.unlock()
