# SPDX-License-Identifier: MIT
class_name SyntheticStars
extends RefCounted
## Catalogues of invented stars, made by tools/synthetic_stars.

const BUILDER: String = "res://tools/synthetic_stars/build_synthetic.py"


## Writes such a file into the folder and returns its path; nothing when the builder fails.
static func write(folder: ScratchFolder, stars: int) -> String:
	var path := folder.file("synthetic_%d.stars" % stars)
	var arguments: PackedStringArray = [
		ProjectSettings.globalize_path(BUILDER),
		ProjectSettings.globalize_path(path),
		"--stars",
		str(stars),
	]
	var printed := []
	if OS.execute("python3", arguments, printed, true) != 0:
		printerr("".join(printed))
		return ""
	return path
