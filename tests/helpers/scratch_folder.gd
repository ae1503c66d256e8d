# SPDX-License-Identifier: MIT
class_name ScratchFolder
extends RefCounted
## A folder for the files a test writes; gone when nobody holds it any more.

var path: String


func _init(folder_name: String) -> void:
	path = "user://scratch_%s_%d" % [folder_name, OS.get_process_id()]
	DirAccess.make_dir_recursive_absolute(path)


func _notification(what: int) -> void:
	if what == NOTIFICATION_PREDELETE:
		for written in DirAccess.get_files_at(path):
			DirAccess.remove_absolute(path.path_join(written))
		DirAccess.remove_absolute(path)


## The path of a file in the folder.
func file(file_name: String) -> String:
	return path.path_join(file_name)


## Writes a text file and returns its path.
func write_text(file_name: String, text: String) -> String:
	return write_bytes(file_name, text.to_utf8_buffer())


## Writes a file and returns its path.
func write_bytes(file_name: String, bytes: PackedByteArray) -> String:
	var out := FileAccess.open(file(file_name), FileAccess.WRITE)
	out.store_buffer(bytes)
	out.close()
	return file(file_name)
