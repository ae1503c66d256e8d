# SPDX-License-Identifier: MIT
class_name SelfTestScene
extends Control
## The self-test as a program: prints the table, writes JSON if asked to, and quits with 0, with 1
## when a check has failed, with 2 when nothing could be checked.
##
##     godot --path . -- --self-test[=FILE.json]

@onready var _progress: Label = %Progress


func _ready() -> void:
	_run.call_deferred()


## The file that a command line wants to be written, or an empty string.
static func file_asked_for(arguments: PackedStringArray) -> String:
	return CommandLine.value(arguments, ProgramMode.SELF_TEST_ARGUMENT + "=")


func _run() -> void:
	if DisplayServer.get_name() == "headless":
		_give_up("nothing is drawn with --headless. Start without it.")
		return
	var test := SelfTest.new()
	add_child(test)
	test.progressed.connect(_on_progressed)
	var results: Array[CheckResult] = await test.run()
	print("\n".join(SelfTestReport.lines(results)))
	var path := file_asked_for(CommandLine.of_program())
	if not path.is_empty():
		var file := FileAccess.open(path, FileAccess.WRITE)
		if file == null or not file.store_string(SelfTestReport.json(results)):
			_give_up("%s cannot be written. Check folder and disk." % path)
			return
		file.close()
	get_tree().quit(0 if SelfTest.have_passed(results) else 1)


func _on_progressed(done: int, total: int, result: CheckResult) -> void:
	_progress.text = "%d / %d  %s" % [done, total, result.name]


func _give_up(reason: String) -> void:
	printerr("self-test: %s" % reason)
	get_tree().quit(2)
