# SPDX-License-Identifier: MIT
extends SceneTree
## Loads every file named in the list given as argument, so that the engine says what it thinks of
## each; run with the engine's local debugger (-d), which alone prints script warnings.


func _initialize() -> void:
	var arguments := OS.get_cmdline_user_args()
	for path in FileAccess.get_file_as_string(arguments[0]).split("\n", false):
		print("loaded %s %s" % [path, "well" if load(path) != null else "not at all"])
	quit(0)
