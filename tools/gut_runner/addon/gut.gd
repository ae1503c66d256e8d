# SPDX-License-Identifier: MIT
class_name GutMain
extends Node
## Runs the tests: hooks, scripts, lifecycle calls, results.

const Collector := preload("parts/collector.gd")
const ErrorTracker := preload("parts/error_tracker.gd")
const JunitWriter := preload("parts/junit_writer.gd")
const Options := preload("parts/options.gd")
const Report := preload("parts/report.gd")
const Results := preload("parts/results.gd")

var log_level: int = 1
## What the engine's log received since the current test (or before_all) began.
var error_tracker: ErrorTracker = ErrorTracker.new()
## False: errors fail nothing and cannot be asserted.
var tracks_errors: bool = true

var _options: Options = Options.new()
var _report: Report = null
var _results: Results = Results.new()
var _pre_run: GutHookScript = null
var _post_run: GutHookScript = null


## Does a whole run as the command line says and returns the exit code.
func run_command_line(arguments: PackedStringArray) -> int:
	_options.read(arguments)
	log_level = _options.values["log_level"]
	_report = Report.new(log_level, not _options.values["disable_colors"])
	if _options.wants_help:
		print(FileAccess.get_file_as_string(Options.HELP))
		return 0
	if not _options.error.is_empty():
		_report.complain(_options.error)
		return 1
	_pre_run = _load_hook("pre_run_script")
	_post_run = _load_hook("post_run_script")
	if _results.complaints.is_empty():
		await _run_all()
	_report.summary(_results)
	return await _finish()


## Prints a text when the log level is at least the given one.
func p(text: Variant, level: int = 0) -> void:
	if log_level >= level:
		print("    " + str(text))


func get_summary() -> Results:
	return _results


func get_test_script_count() -> int:
	return _results.scripts.size()


func get_pre_run_script_instance() -> GutHookScript:
	return _pre_run


func get_post_run_script_instance() -> GutHookScript:
	return _post_run


## Notes a wait at log level 3.
func note_wait(message: String) -> void:
	_report.waiting(message)


func _load_hook(key: String) -> GutHookScript:
	var path: String = _options.values[key]
	if path.is_empty():
		return null
	var script: GDScript = load(path) as GDScript if FileAccess.file_exists(path) else null
	if script == null or not script.can_instantiate():
		_results.complaints.append("the hook %s does not exist or does not compile" % path)
		return null
	var instance: Variant = script.new()
	if instance is not GutHookScript:
		_results.complaints.append("the hook %s does not extend GutHookScript" % path)
		return null
	var hook: GutHookScript = instance
	hook.gut = self
	return hook


func _run_all() -> void:
	if _pre_run != null:
		@warning_ignore("redundant_await")
		await _pre_run.run()
		if _pre_run.should_abort():
			_results.complaints.append("the pre-run hook called the run off")
			return
	tracks_errors = not _options.values["no_error_tracking"]
	if tracks_errors:
		OS.add_logger(error_tracker)
	var collector: Collector = Collector.new()
	collector.collect(_options.values)
	_results.complaints.append_array(collector.complaints)
	for complaint: String in collector.complaints:
		_report.complain(complaint)
	_complain_about_stray_errors("while collecting the tests")
	for i: int in collector.suites.size():
		_report.script_begins(collector.suites[i].name, i + 1, collector.suites.size())
		await _run_suite(collector.suites[i])
	if tracks_errors:
		OS.remove_logger(error_tracker)


func _finish() -> int:
	var junit_file: String = _options.values["junit_xml_file"]
	var code: int = _results.exit_code()
	if not junit_file.is_empty():
		var problem: String = JunitWriter.write(_results, junit_file)
		if not problem.is_empty():
			_report.complain(problem)
			code = 1
	if _post_run != null and (_pre_run == null or not _pre_run.should_abort()):
		@warning_ignore("redundant_await")
		await _post_run.run()
		if _post_run.get_exit_code() != null:
			return _post_run.get_exit_code()
	return code


func _run_suite(suite: Collector.Suite) -> void:
	var script_result: Results.ScriptResult = Results.ScriptResult.new(suite.name)
	_results.scripts.append(script_result)
	var test: GutTest = suite.source.new()
	test.gut = self
	var skip: Variant = await test.should_skip_script()
	if skip is String or (skip is bool and skip):
		script_result.skip_reason = str(skip) if skip is String else "should_skip_script()"
	else:
		add_child(test)
		_complain_about_stray_errors("before %s" % suite.name)
		await _run_around(test, &"before_all", script_result)
		for test_name: String in suite.tests:
			await _run_test(test, test_name, script_result)
		await _run_around(test, &"after_all", script_result)
	_report.script_ended(script_result)
	test.free()
	# Lets queue_free() of the script's nodes happen before the next script begins.
	await get_tree().process_frame
	_complain_about_stray_errors("after %s" % suite.name)


## before_all and after_all appear among the results only when something failed in them.
func _run_around(test: GutTest, method: StringName, script_result: Results.ScriptResult) -> void:
	var result: Results.TestResult = Results.TestResult.new(method)
	test.begin_test(result)
	await test.call(method)
	_fail_on_errors(test)
	test.end_test()
	if result.status() == "fail":
		script_result.tests.append(result)
		_report.test_ended(result)


func _run_test(test: GutTest, test_name: String, script_result: Results.ScriptResult) -> void:
	var result: Results.TestResult = Results.TestResult.new(test_name)
	script_result.tests.append(result)
	_report.test_begins(test_name)
	var start: int = Time.get_ticks_usec()
	test.begin_test(result)
	var takes_parameter: bool = test.get_method_argument_count(test_name) > 0
	while true:
		test.begin_call()
		@warning_ignore("redundant_await")
		await test.before_each()
		if takes_parameter and not test.has_default_parameter(test_name):
			test.fail_test("its parameter has no default; it must be use_parameters(...)")
		else:
			await test.call(test_name)
		@warning_ignore("redundant_await")
		await test.after_each()
		test.end_call()
		_fail_on_errors(test)
		if not test.has_more_parameters():
			break
	if takes_parameter and not test.used_parameters():
		test.fail_test("its parameter does not default to use_parameters(...)")
	test.end_test()
	result.seconds = (Time.get_ticks_usec() - start) * 1e-6
	_report.test_ended(result)


func _fail_on_errors(test: GutTest) -> void:
	var failing_types: PackedStringArray = _options.values["failure_error_types"]
	var texts: PackedStringArray = []
	for error: GutTrackedError in error_tracker.get_unhandled(failing_types):
		texts.append(error.to_s())
	error_tracker.clear()
	if not texts.is_empty():
		test.fail_test("unexpected errors:\n" + "\n".join(texts))


## An error outside the tests belongs to none of them; it fails the run. Warnings do not.
func _complain_about_stray_errors(when: String) -> void:
	for error: GutTrackedError in error_tracker.get_errors():
		if error.error_type != Logger.ERROR_TYPE_WARNING:
			_results.complaints.append("error %s: %s" % [when, error.to_s()])
	error_tracker.clear()
