# SPDX-License-Identifier: MIT
class_name GutTrackedError
extends RefCounted
## One error or warning that the engine's log received while a test ran.

var code: String = ""
var rationale: String = ""
## A Logger.ErrorType.
var error_type: int = -1
var file: String = ""
var function: String = ""
var line: int = -1
var backtrace: Array[ScriptBacktrace] = []
## True once a test has dealt with the error; it then does not fail the test.
var handled: bool = false


func is_push_error() -> bool:
	return function == "push_error" and error_type == Logger.ERROR_TYPE_ERROR


func is_push_warning() -> bool:
	return function == "push_warning" and error_type == Logger.ERROR_TYPE_WARNING


## Everything the log received that a script did not push itself, the engine's own warnings
## included.
func is_engine_error() -> bool:
	return not is_push_error() and not is_push_warning()


## Errors of the runner itself are not tracked.
func is_gut_error() -> bool:
	return false


## Whether the message contains a text; upper and lower case are the same.
func contains_text(text: String) -> bool:
	return text.to_lower() in (code + "\n" + rationale).to_lower()


func get_error_type_name() -> String:
	if is_push_error():
		return "push_error"
	return "push_warning" if is_push_warning() else "engine"


func to_s() -> String:
	var message: String = code if rationale.is_empty() else "%s (%s)" % [rationale, code]
	return "<%s> %s [%s:%d]" % [get_error_type_name(), message, file, line]
