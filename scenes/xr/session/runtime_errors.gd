# SPDX-License-Identifier: MIT
class_name RuntimeErrors
extends Logger
## Listens to what the engine says about the headset's runtime: it prints that the session or the
## connection is lost, but tells no script. May be called from any thread.

## Any of these in an error means that the runtime is gone.
const SIGNS: PackedStringArray = [
	"OpenXR: Failed to poll events", "XR_ERROR_SESSION_LOST", "XR_ERROR_INSTANCE_LOST"
]

var _lock := Mutex.new()
var _seen: bool = false


## Has there been such an error yet?
func has_seen_loss() -> bool:
	_lock.lock()
	var seen := _seen
	_lock.unlock()
	return seen


func _log_error(
	_function: String,
	_file: String,
	_line: int,
	code: String,
	rationale: String,
	_editor_notify: bool,
	_error_type: int,
	_backtraces: Array[ScriptBacktrace]
) -> void:
	for sign_of_loss in SIGNS:
		if rationale.contains(sign_of_loss) or code.contains(sign_of_loss):
			_lock.lock()
			_seen = true
			_lock.unlock()
			return
