# SPDX-License-Identifier: MIT
## Runs every test_* method of the scripts in res://cases and writes the results as JSON.
##
## Started as [code]godot --headless -s res://run_tests.gd -- --results=FILE [--upstream][/code].
## With --leak it leaks on purpose instead, to show that the sanitizer would see it.
extends SceneTree

const ProviderCase := preload("res://cases/provider_case.gd")
const CASES := "res://cases"


func _initialize() -> void:
	await process_frame
	var arguments := OS.get_cmdline_user_args()
	if arguments.has("--leak"):
		ProbeCalls.new().leak_on_purpose()
		quit()
		return
	var results_file := ""
	for argument: String in arguments:
		if argument.begins_with("--results="):
			results_file = argument.trim_prefix("--results=")
	var results: Array[Dictionary] = []
	for file_name: String in DirAccess.get_files_at(CASES):
		if file_name.begins_with("test_") and file_name.ends_with(".gd"):
			results.append_array(await _run_script(CASES.path_join(file_name)))
	var file := FileAccess.open(results_file, FileAccess.WRITE)
	file.store_string(JSON.stringify({"finished": true, "cases": results}))
	file.close()
	quit(1 if results.any(_has_failed) else 0)


func _has_failed(result: Dictionary) -> bool:
	return not (result["failures"] as PackedStringArray).is_empty()


func _run_script(path: String) -> Array[Dictionary]:
	var results: Array[Dictionary] = []
	var script: GDScript = load(path)
	for method: Dictionary in script.get_script_method_list():
		var test_name: String = method["name"]
		if not test_name.begins_with("test_"):
			continue
		var case: ProviderCase = script.new()
		case.tree = self
		case.strict = not OS.get_cmdline_user_args().has("--upstream")
		var started := Time.get_ticks_usec()
		case.begin()
		@warning_ignore("redundant_await")
		await case.call(test_name)
		case.finish()
		(
			results
			. append(
				{
					"suite": path.get_file().get_basename(),
					"name": test_name,
					"seconds": (Time.get_ticks_usec() - started) * 1e-6,
					"failures": case.failures,
				}
			)
		)
		for failure: String in case.failures:
			print("FAILED %s.%s: %s" % [path.get_file().get_basename(), test_name, failure])
	return results
