# SPDX-License-Identifier: MIT
class_name ErrorListener
extends Logger
## Hears the engine's errors: a shader that a driver refuses is told there and nowhere else.

var _guard := Mutex.new()
var _heard: PackedStringArray = []


## What was heard since the last call. The first line of each error.
func take() -> PackedStringArray:
	_guard.lock()
	var heard := _heard
	_heard = []
	_guard.unlock()
	return heard


func _log_error(
	function: String,
	_file: String,
	_line: int,
	code: String,
	rationale: String,
	_editor_notify: bool,
	error_type: int,
	_backtraces: Array[ScriptBacktrace]
) -> void:
	if error_type == ERROR_TYPE_WARNING:
		return
	var words := code if rationale.is_empty() else rationale
	_guard.lock()
	words = words.strip_edges().get_slice("\n", 0)
	_heard.append(words if function.is_empty() else "%s: %s" % [function, words])
	_guard.unlock()
