# SPDX-License-Identifier: MIT
class_name RecentErrors
extends Logger
## Listens to what the engine calls errors and warnings and keeps the last of them. May be called
## from any thread.

const MOST: int = 12

var _lock := Mutex.new()
var _texts: PackedStringArray = []
var _fresh: PackedStringArray = []
var _count: int = 0


## How many there have been.
func get_count() -> int:
	_lock.lock()
	var count := _count
	_lock.unlock()
	return count


## The last ones, the newest first.
func get_texts() -> PackedStringArray:
	_lock.lock()
	var texts := _texts.duplicate()
	_lock.unlock()
	texts.reverse()
	return texts


## Those that have come since the last call, as many as are kept.
func take_fresh() -> PackedStringArray:
	_lock.lock()
	var texts := _fresh
	_fresh = PackedStringArray()
	_lock.unlock()
	return texts


func _log_error(
	_function: String,
	file: String,
	line: int,
	code: String,
	rationale: String,
	_editor_notify: bool,
	_error_type: int,
	_backtraces: Array[ScriptBacktrace]
) -> void:
	var what := rationale if not rationale.is_empty() else code
	_lock.lock()
	_count += 1
	# Those of scripts come by way of the engine's own file, which tells nothing.
	var is_own := file.ends_with("variant_utility.cpp")
	var text := what if is_own else "%s (%s:%d)" % [what, file.get_file(), line]
	# One that comes with every frame would fill everything.
	if _texts.is_empty() or _texts[-1] != text:
		_keep(_texts, text)
		_keep(_fresh, text)
	_lock.unlock()


func _keep(texts: PackedStringArray, text: String) -> void:
	texts.append(text)
	if texts.size() > MOST:
		texts.remove_at(0)
