# SPDX-License-Identifier: MIT
class_name AtomicFile
extends RefCounted
## Writes small text files so that a power cut or a kill at any moment leaves a readable one: the
## old text or the new one.
##
## The new text is written beside the file, then renamed over it. Renaming is safe against a kill,
## but not against a power cut: names may reach the disk before what is in the file does. So a
## former file is kept as well, one that had time to reach the disk.

## What is added to the name of the text on its way, and of the former one.
const NEW: String = ".new"
const FORMER: String = ".bak"
## Larger files are none of those that are written here.
const MOST_BYTES: int = 1 << 18
## Seconds after which a file is surely on the disk.
const RESTED: int = 60

# Which files could not be written last time: told once, not at every try.
static var _failed: Dictionary[String, bool] = {}


## Writes `text` to the file `path`. On failure what was there stays, and a warning tells why.
static func write(path: String, text: String) -> Error:
	var error := _write_beside(path, text)
	if error == OK:
		error = _put_in_place(path)
	_tell(path, error)
	return error


## The text of the file `path`, or of what an interrupted [method write] left beside it: the first
## that `is_good`, which takes a text and says whether it is whole. Empty when there is none.
static func read(path: String, is_good: Callable) -> String:
	for candidate: String in [path, path + NEW, path + FORMER]:
		if FileAccess.file_exists(candidate):
			var text := BoundedText.from_file(candidate, MOST_BYTES).text
			var good: bool = is_good.call(text)
			if good:
				return text
	return ""


## Removes the file and what lies beside it.
static func remove(path: String) -> void:
	for candidate: String in [path, path + NEW, path + FORMER]:
		if FileAccess.file_exists(candidate):
			DirAccess.remove_absolute(candidate)


static func _write_beside(path: String, text: String) -> Error:
	if not DirAccess.dir_exists_absolute(path.get_base_dir()):
		DirAccess.make_dir_recursive_absolute(path.get_base_dir())
	var out := FileAccess.open(path + NEW, FileAccess.WRITE)
	if out == null:
		return FileAccess.get_open_error()
	var bytes := text.to_utf8_buffer()
	out.store_buffer(bytes)
	out.close()
	# A full disk is noticed only so.
	if FileAccess.get_size(path + NEW) != bytes.size():
		DirAccess.remove_absolute(path + NEW)
		return ERR_FILE_CANT_WRITE
	return OK


static func _put_in_place(path: String) -> Error:
	if FileAccess.file_exists(path) and _is_to_be_kept(path):
		var error := DirAccess.rename_absolute(path, path + FORMER)
		if error != OK:
			return error
	return DirAccess.rename_absolute(path + NEW, path)


static func _is_to_be_kept(path: String) -> bool:
	if not FileAccess.file_exists(path + FORMER):
		return true
	var age := Time.get_unix_time_from_system() - FileAccess.get_modified_time(path)
	return absf(age) > RESTED


static func _tell(path: String, error: Error) -> void:
	if error == OK:
		_failed.erase(path)
	elif not _failed.has(path):
		_failed[path] = true
		push_warning(
			(
				"%s cannot be written: %s. Check that the folder may be written and the disk has room."
				% [ProjectSettings.globalize_path(path), error_string(error)]
			)
		)
