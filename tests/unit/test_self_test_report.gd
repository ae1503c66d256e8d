# SPDX-License-Identifier: MIT
extends GutTest
## Results of the self-test, their report, and the command line that asks for it.


func test_the_worst_for_its_limit_is_kept() -> void:
	var result := CheckResult.new()
	result.compare("place", 0.05, 0.1, "px")
	result.compare("light", -0.04, 0.05)
	result.compare("place", 0.06, 0.1, "px")
	assert_eq(result.quantity, "light")
	assert_eq(result.worst, 0.04)
	assert_eq(result.limit, 0.05)
	assert_true(result.has_passed())
	result.compare("place", 0.11, 0.1, "px")
	assert_eq(result.quantity, "place")
	assert_eq(result.unit, "px")
	assert_false(result.has_passed())


func test_what_fails() -> void:
	assert_false(CheckResult.new().has_passed(), "nothing was measured")
	assert_false(_measured(NAN, 1.0).has_passed(), "no number")
	assert_false(_measured(INF, 1.0).has_passed(), "infinite")
	assert_false(_measured(1.0, 0.0).has_passed(), "none is allowed")
	assert_true(_measured(0.0, 0.0).has_passed(), "none is there")
	var objected := _measured(0.0, 1.0)
	objected.object("The driver gave up.")
	objected.object("The driver gave up.")
	assert_false(objected.has_passed(), "something is objected")
	assert_eq(objected.objections, PackedStringArray(["The driver gave up."]))


func test_no_number_stays_the_worst() -> void:
	var result := _measured(NAN, 1.0)
	result.compare("other", 5.0, 1.0)
	assert_true(is_nan(result.worst))


func test_verdicts() -> void:
	var good := _measured(0.0, 1.0, &"good")
	var bad := _measured(2.0, 1.0, &"bad")
	assert_true(SelfTest.have_passed([good]))
	assert_false(SelfTest.have_passed([good, bad]))
	assert_false(SelfTest.have_passed([]), "nothing was checked")
	assert_string_contains(SelfTestReport.verdict([good]), "1 of 1 checks passed")
	var verdict := SelfTestReport.verdict([good, bad])
	assert_string_contains(verdict, "NOT")
	assert_string_contains(verdict, "1 of 2 checks failed (bad)")


func test_the_table_names_fault_and_remedy() -> void:
	var text := "\n".join(SelfTestReport.lines([_measured(0.0, 1.0, &"good"), _bad()]))
	for words: String in ["FAULT bad: Stars are lost.", "remedy: Take another card.", "Oh no."]:
		assert_string_contains(text, words)
	assert_eq(text.count("FAULT"), 2, "in the row and above the remedy")
	assert_eq(text.count("remedy"), 1)
	assert_string_contains(text, RenderingServer.get_current_rendering_method())


func test_the_last_line_says_pass_or_fail() -> void:
	var good := SelfTestReport.lines([_measured(0.0, 1.0, &"good")])
	assert_true(good[-1].begins_with("PASS: "), good[-1])
	var bad := SelfTestReport.lines([_bad()])
	assert_true(bad[-1].begins_with("FAIL: "), bad[-1])
	assert_string_contains("\n".join(good), "addon     " + ProgramVersion.text())


func test_json_says_the_same() -> void:
	var found: Dictionary = JSON.parse_string(SelfTestReport.json([_bad(), _measured(NAN, 1.0)]))
	assert_false(found["passed"])
	assert_true(
		found.has_all(["device", "driver", "renderer", "godot", "addon", "verdict", "report"])
	)
	var first: Dictionary = found["checks"][0]
	assert_eq(first["check"], "bad")
	assert_eq(first["worst"], 2.0)
	assert_eq(first["remedy"], "Take another card.")
	assert_eq(first["objections"], ["Oh no."])
	assert_null(found["checks"][1]["worst"], "JSON knows no NaN")


func test_every_check_has_words() -> void:
	var names: Array[StringName] = []
	for check in SelfTest.all_checks():
		assert_does_not_have(names, check.name)
		names.append(check.name)
		for words: String in [check.compares, check.fault, check.remedy]:
			assert_gt(words.length(), 20, "%s" % check.name)


func test_the_shaders_of_the_addon_are_found() -> void:
	var files: PackedStringArray = []
	for file in DirAccess.get_files_at(ShadersCheck.FOLDER):
		if file.ends_with(".gdshader"):
			files.append(ShadersCheck.FOLDER.path_join(file))
	assert_has(files, ShadersCheck.FOLDER.path_join("stars_lensed.gdshader"))
	assert_eq(ShadersCheck.addon_shaders(), files)


func test_the_command_line() -> void:
	assert_eq(SelfTestScene.file_asked_for(["--self-test"]), "")
	assert_eq(SelfTestScene.file_asked_for(["--self-test=a=b.json"]), "a=b.json")


func test_without_a_picture_nothing_can_be_checked() -> void:
	var said: Array = []
	var command: PackedStringArray = [
		"--headless", "--path", ProjectSettings.globalize_path("res://")
	]
	command.append_array(["--", "--self-test"])
	assert_eq(OS.execute(OS.get_executable_path(), command, said, true), 2)
	var text: String = said[0]
	assert_string_contains(text, "self-test: nothing is drawn with --headless")


func test_errors_are_heard_once() -> void:
	var listener := ErrorListener.new()
	OS.add_logger(listener)
	push_error("first line\nsecond line")
	push_warning("no error")
	OS.remove_logger(listener)
	push_error("too late")
	assert_push_error("first line")
	assert_push_error("too late")
	var heard := listener.take()
	assert_eq(heard.size(), 1)
	assert_string_contains(heard[0], "first line")
	assert_false(heard[0].contains("second"))
	assert_eq(listener.take().size(), 0)


func _measured(error: float, limit: float, whose: StringName = &"some") -> CheckResult:
	var result := CheckResult.new()
	result.name = whose
	result.compare("something", error, limit)
	return result


func _bad() -> CheckResult:
	var result := _measured(2.0, 1.0, &"bad")
	result.fault = "Stars are lost."
	result.remedy = "Take another card."
	result.object("Oh no.")
	return result
