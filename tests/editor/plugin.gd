# SPDX-License-Identifier: MIT
@tool
extends EditorPlugin
## Runs the tests of this folder in the editor itself, writes what came out, and ends the editor.
##
## Works where BLACKHOLE_EDITOR_RESULTS names the JSON file for it: a list of name, group and
## failure. BLACKHOLE_EDITOR_TESTS names the scripts to run, separated by commas.

const EditorCase := preload("editor_case.gd")
const QUIET_FRAMES: int = 5

var _results: Array[Dictionary] = []


func _enter_tree() -> void:
	if not OS.get_environment("BLACKHOLE_EDITOR_RESULTS").is_empty():
		_run.call_deferred()


func _run() -> void:
	await _until_scanned()
	for script in OS.get_environment("BLACKHOLE_EDITOR_TESTS").split(",", false):
		await _run_script(script)
	var out := FileAccess.open(OS.get_environment("BLACKHOLE_EDITOR_RESULTS"), FileAccess.WRITE)
	out.store_string(JSON.stringify(_results))
	out.close()
	get_tree().quit()


func _until_scanned() -> void:
	var quiet := 0
	while quiet < QUIET_FRAMES:
		await get_tree().process_frame
		quiet = 0 if EditorInterface.get_resource_filesystem().is_scanning() else quiet + 1


func _run_script(script: String) -> void:
	var own: Script = get_script()
	var path := own.resource_path.get_base_dir().path_join(script + ".gd")
	var tests: GDScript = load(path)
	var case: EditorCase = tests.new(get_tree())
	for method in tests.get_script_method_list():
		var test: String = method["name"]
		if test.begins_with("test_"):
			print("editor check: %s %s" % [script, test])
			case.failures.clear()
			await case.call(test)
			_results.append({"name": test, "group": script, "failure": "\n".join(case.failures)})
