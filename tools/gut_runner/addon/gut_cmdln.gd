# SPDX-License-Identifier: MIT
extends SceneTree
## Entry of the command line: godot --headless -s addons/gut/gut_cmdln.gd [options].
##
## Exit code 0: every test passed. 1: a test failed, nothing ran, a script could not be loaded, or
## the command line or configuration is wrong. A post-run hook may set another code.

const NEEDED_CLASSES: Array[StringName] = [
	&"GutTest", &"GutMain", &"GutHookScript", &"GutInputSender", &"GutTrackedError"
]


func _initialize() -> void:
	var known: Array[StringName] = []
	for entry: Dictionary in ProjectSettings.get_global_class_list():
		known.append(entry["class"])
	for needed: StringName in NEEDED_CLASSES:
		if needed not in known:
			printerr("The class %s is not known to the project." % needed)
			printerr("Run this once: godot --headless --path . --import")
			quit(1)
			return
	_run()


func _run() -> void:
	await process_frame
	# Loaded by path and late: the class names inside resolve only once the check above has passed.
	var script: GDScript = load("res://addons/gut/gut.gd")
	if script == null or not script.can_instantiate():
		printerr("res://addons/gut is incomplete: install the runner again.")
		quit(1)
		return
	var runner: Node = script.new()
	root.add_child(runner)
	var code: Variant = await runner.call(&"run_command_line", OS.get_cmdline_args())
	runner.free()
	quit(code if code is int else 1)
