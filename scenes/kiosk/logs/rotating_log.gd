# SPDX-License-Identifier: MIT
class_name RotatingLog
extends RefCounted
## A log of lines that never grows too large, and that a full disk does not stop: lines wait until
## there is room again.

## A line is not longer than this, bytes.
const LONGEST_LINE: int = 4096
## So many lines wait at most; older ones are then given up.
const MOST_WAITING: int = 2000

## Why the last line could not be written, for people; empty: it could.
var fault: String = ""
var path: String

var _most_bytes: int
var _count: int
var _head: String
var _waiting: PackedStringArray = []


## `head`: the first line of each file, empty for none.
func _init(file: String, most_bytes: int, older_count: int, head: String = "") -> void:
	path = file
	_most_bytes = most_bytes
	_count = older_count
	_head = head


## Adds a line.
func add(line: String) -> void:
	_waiting.append(line)
	if _waiting.size() > MOST_WAITING:
		_waiting.remove_at(0)
	flush()


## Adds a line with the time before it.
func note(text: String) -> void:
	add("%s %s" % [Time.get_datetime_string_from_system(false, true), text.replace("\n", " | ")])


## Writes what waits. False: it still waits, and `fault` says why.
func flush() -> bool:
	if _waiting.is_empty():
		return true
	var text := "\n".join(_waiting) + "\n"
	_rotate_for(text.length())
	if not _write(text):
		return false
	_waiting.clear()
	fault = ""
	return true


## The last line that is not the head, in this file or the one before it; empty: there is none.
func get_last_line() -> String:
	for file: String in [path, _older(1)]:
		var lines := _end_of(file).split("\n", false)
		if not lines.is_empty() and lines[-1] != _head:
			return lines[-1]
	return ""


func _end_of(file: String) -> String:
	var read := FileAccess.open(file, FileAccess.READ)
	if read == null:
		return ""
	read.seek(maxi(0, read.get_length() - LONGEST_LINE))
	var bytes := read.get_buffer(LONGEST_LINE)
	# Not from the middle of a line, which may be the middle of a character.
	if read.get_length() > LONGEST_LINE:
		bytes = bytes.slice(bytes.find(10) + 1)
	return BoundedText.text_of(bytes)


func _older(age: int) -> String:
	return "%s.%d" % [path, age]


func _rotate_for(bytes: int) -> void:
	if not FileAccess.file_exists(path) or FileAccess.get_size(path) + bytes <= _most_bytes:
		return
	DirAccess.remove_absolute(_older(_count))
	for age in range(_count - 1, 0, -1):
		if FileAccess.file_exists(_older(age)):
			DirAccess.rename_absolute(_older(age), _older(age + 1))
	DirAccess.rename_absolute(path, _older(1))


func _write(text: String) -> bool:
	DirAccess.make_dir_recursive_absolute(path.get_base_dir())
	var is_there := FileAccess.file_exists(path)
	var file := FileAccess.open(path, FileAccess.READ_WRITE if is_there else FileAccess.WRITE)
	if file == null:
		_fail(error_string(FileAccess.get_open_error()))
		return false
	var before := file.get_length()
	if before == 0 and not _head.is_empty():
		text = _head + "\n" + text
	file.seek_end()
	file.store_string(text)
	file.flush()
	# The engine tells of a full disk in no other way.
	if file.get_length() == before + text.to_utf8_buffer().size():
		return true
	file.resize(before)
	_fail("the disk is full or cannot be written")
	return false


func _fail(why: String) -> void:
	fault = (
		"%s cannot be written: %s. Make room on the disk, or let the program write there."
		% [ProjectSettings.globalize_path(path), why]
	)
