# SPDX-License-Identifier: MIT
class_name Heartbeat
extends RefCounted
## The exhibit's sign of life: a small file, written anew all the time, that also says how it is.
##
## Written whole or not at all; on a full disk over the old one, which needs no room: a full disk
## is no reason to be taken for dead.

const FILE_NAME: String = "heartbeat.json"
## It is written as often as this, seconds.
const EVERY_SECONDS: float = 1.0
## Always as long, so that a new one fits in the old one's place.
const SIZE: int = 2048

var _path: String
var _task: int = -1
var _beats: int = 0


func _init(folder: String) -> void:
	_path = folder.path_join(FILE_NAME)


## Writes it, on another thread; not while the last one is still being written.
func beat(facts: Dictionary) -> void:
	if _task >= 0:
		if not WorkerThreadPool.is_task_completed(_task):
			return
		WorkerThreadPool.wait_for_task_completion(_task)
	_task = WorkerThreadPool.add_task(_write.bind(_text(facts)))


## Writes it before the program ends.
func beat_now(facts: Dictionary) -> void:
	wait()
	_write(_text(facts))


func wait() -> void:
	if _task >= 0:
		WorkerThreadPool.wait_for_task_completion(_task)
		_task = -1


## What a heartbeat file says; empty when it says nothing (yet).
static func read(folder: String) -> Dictionary:
	var path := folder.path_join(FILE_NAME)
	if not FileAccess.file_exists(path):
		return {}
	var parser := JSON.new()
	var text := BoundedText.from_file(path, AtomicFile.MOST_BYTES).text
	if parser.parse(text) != OK or not parser.data is Dictionary:
		return {}
	return parser.data if not JsonKinds.is_deeper(parser.data, 4) else {}


func _text(facts: Dictionary) -> String:
	_beats += 1
	var told := facts.duplicate()
	told["beat"] = _beats
	told["pid"] = OS.get_process_id()
	told["time"] = Time.get_unix_time_from_system()
	return JSON.stringify(told)


func _write(text: String) -> void:
	var bytes := text.to_utf8_buffer()
	if bytes.size() >= SIZE:
		return
	var room := PackedByteArray()
	room.resize(SIZE - bytes.size())
	room.fill(0x20)
	bytes.append_array(room)
	DirAccess.make_dir_recursive_absolute(_path.get_base_dir())
	if _store(_path + ".new", bytes, FileAccess.WRITE):
		DirAccess.rename_absolute(_path + ".new", _path)
	elif FileAccess.file_exists(_path):
		_store(_path, bytes, FileAccess.READ_WRITE)


func _store(path: String, bytes: PackedByteArray, how: FileAccess.ModeFlags) -> bool:
	var file := FileAccess.open(path, how)
	if file == null:
		return false
	file.store_buffer(bytes)
	file.close()
	return FileAccess.get_size(path) == bytes.size()
