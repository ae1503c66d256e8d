# SPDX-License-Identifier: MIT
class_name ShotFiles
extends RefCounted
## Finds the files that a shot names: relative paths in one folder after the other.

var _folders: PackedStringArray


func _init(folders: PackedStringArray) -> void:
	_folders = folders


## Where the file is; empty when it is nowhere.
func find(path: String) -> String:
	if path.is_absolute_path():
		return path if FileAccess.file_exists(path) else ""
	for folder in _folders:
		var candidate := folder.path_join(path)
		if not folder.is_empty() and FileAccess.file_exists(candidate):
			return candidate
	return ""
