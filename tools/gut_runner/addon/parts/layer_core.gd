# SPDX-License-Identifier: MIT
extends Node
## Foundation of GutTest: outcome of the running test, lifecycle, parameters.

const Results := preload("results.gd")

# Untyped on purpose, like GUT's own: what compiles here compiles there.
# gdlint: disable=class-variable-name
var ParameterFactory: Variant = preload("parameter_factory.gd")
var InputSender: Variant = preload("../input_sender.gd")
# gdlint: enable=class-variable-name

## The runner.
var gut: GutMain = null

var _result: Results.TestResult = null
var _parameters: Array = []
var _parameter_index: int = -1

## Override to skip the whole script: true, or the reason as a text. Without a type, as in GUT: an
## override must not name one either.
@warning_ignore("untyped_declaration")
func should_skip_script():
	return false


## Override: called once before the first test. May await, like the other three.
func before_all() -> void:
	pass


## Override: called before every test.
func before_each() -> void:
	pass


## Override: called after every test.
func after_each() -> void:
	pass


## Override: called once after the last test.
func after_all() -> void:
	pass


## Marks the test as pending: neither passed nor failed.
func pending(text: Variant = "") -> void:
	_result.pendings.append(str(text))


## Counts as a passing assert.
func pass_test(_text: Variant) -> void:
	_result.passes += 1


## Counts as a failing assert.
func fail_test(text: Variant) -> void:
	_fail(str(text))


## Whether the running test has passed an assert and failed none.
func is_passing() -> Variant:
	return _result.status() != "fail" and _result.passes > 0


func is_failing() -> Variant:
	return _result.status() == "fail"


## Default value of a test's only parameter: the test is called once for each element.
func use_parameters(parameters: Variant) -> Variant:
	# Packed arrays are none: an Array is asked for.
	if not parameters is Array:
		_fail("use_parameters() must be given an Array")
		return null
	if _parameter_index < 0:
		_parameters = parameters
	_parameter_index += 1
	if _parameter_index >= _parameters.size():
		_fail("use_parameters() was given an empty array")
		return null
	return _parameters[_parameter_index]


## For the runner: a test (or before_all, after_all) begins.
func begin_test(result: Results.TestResult) -> void:
	_result = result
	_parameters = []
	_parameter_index = -1


## For the runner: the test is over.
func end_test() -> void:
	_result = Results.TestResult.new("after the end of a test")


## For the runner: one call of a test begins; a test with parameters has several.
func begin_call() -> void:
	pass


## For the runner: one call of a test, with its after_each, is over.
func end_call() -> void:
	pass


## For the runner: whether the test must be called again.
func has_more_parameters() -> bool:
	return _parameter_index >= 0 and _parameter_index < _parameters.size() - 1


## For the runner: whether the test called use_parameters().
func used_parameters() -> bool:
	return _parameter_index >= 0


## For the runner: whether the first parameter of a method has a default value.
func has_default_parameter(method: String) -> bool:
	for info: Dictionary in get_method_list():
		if info["name"] == method:
			var defaults: Array = info["default_args"]
			return not defaults.is_empty()
	return false


func _pass() -> void:
	_result.passes += 1


func _fail(text: String) -> void:
	var line: String = _where()
	var prefix: String = ""
	if _parameter_index >= 0 and _parameter_index < _parameters.size():
		prefix = "params[%d] %s: " % [_parameter_index, _show(_parameters[_parameter_index])]
	_result.fails.append(prefix + text + line)


## Passes or fails; the message is only made for a failure.
func _check(holds: bool, message: String, values: Array, text: Variant) -> void:
	if holds:
		_pass()
		return
	var shown: Array = []
	for value: Variant in values:
		shown.append(_show(value))
	var note: String = str(text)
	_fail(message.format(shown) + ("" if note.is_empty() else ": " + note))


## The line of the test script that is running, as " (at line N)"; empty where it is not known.
func _where() -> String:
	var script: Script = get_script()
	var path: String = script.resource_path
	for backtrace: ScriptBacktrace in Engine.capture_script_backtraces():
		for i: int in backtrace.get_frame_count():
			var file: String = backtrace.get_frame_file(i)
			if file == path or (path.is_empty() and not file.begins_with("res://addons/gut/")):
				return " (at line %d)" % backtrace.get_frame_line(i)
	return ""


## A value as text, floats with all their digits, cut where it is long.
func _show(value: Variant) -> String:
	var text: String = ""
	if typeof(value) in [TYPE_FLOAT, TYPE_STRING, TYPE_VECTOR2, TYPE_VECTOR3, TYPE_VECTOR4]:
		text = var_to_str(value)
	elif value is Object and not is_instance_valid(value):
		text = "<freed object>"
	else:
		text = str(value)
	return text if text.length() <= 500 else text.left(500) + "..."
