# SPDX-License-Identifier: MIT
class_name PhotoFiles
extends RefCounted
## Where photos go, and a name for the next: by date and number, never one that is taken.

const FOLDER_NAME: String = "Black Hole Sky"
## Where there is no folder for pictures.
const FALLBACK: String = "user://photos"
const KINDS: PackedStringArray = ["png", "exr", "json"]
const MOST: int = 9999


## The folder of this user's photos, which is made if need be; in absolute terms.
static func folder() -> String:
	var pictures := OS.get_system_dir(OS.SYSTEM_DIR_PICTURES)
	if not pictures.is_empty() and DirAccess.dir_exists_absolute(pictures):
		var own := pictures.path_join(FOLDER_NAME)
		if DirAccess.make_dir_recursive_absolute(own) == OK:
			return own
	DirAccess.make_dir_recursive_absolute(FALLBACK)
	return ProjectSettings.globalize_path(FALLBACK)


## A path without extension in a folder, under which there is no photo yet: black_hole_DATE_NUMBER.
## Empty when that day has no more numbers.
static func next_name(directory: String, date: String) -> String:
	for number in range(1, MOST + 1):
		var path := directory.path_join("black_hole_%s_%03d" % [date, number])
		if not _is_taken(path):
			return path
	return ""


static func today() -> String:
	return Time.get_date_string_from_system()


static func _is_taken(path: String) -> bool:
	for kind in KINDS:
		if FileAccess.file_exists(path + "." + kind):
			return true
	return false
