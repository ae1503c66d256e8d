# SPDX-License-Identifier: MIT
extends RefCounted
## Finds the test scripts, their inner classes and their tests.

const BASE_SCRIPT := "res://addons/gut/test.gd"
const INNER_PREFIX := "Test"
const TEST_PREFIX := "test_"


## A script or inner class to run.
class Suite:
	extends RefCounted

	## "tests/unit/test_x.gd" or "tests/unit/test_x.gd.TestInner".
	var name: String = ""
	var source: GDScript = null
	## Names of the tests, in the order of the source.
	var tests: PackedStringArray = []


var suites: Array[Suite] = []
## What could not be found or loaded.
var complaints: PackedStringArray = []

var _values: Dictionary[String, Variant]


## Fills suites and complaints from the option values (see options.gd).
func collect(values: Dictionary[String, Variant]) -> void:
	_values = values
	var paths: PackedStringArray = []
	for dir: String in values["dirs"]:
		_find_scripts(dir, paths)
	for path: String in values["tests"]:
		if path not in paths:
			paths.append(path)
	for path: String in paths:
		if str(values["selected"]) in path.get_file() or str(values["selected"]).is_empty():
			_collect_script(path)


func _find_scripts(dir: String, paths: PackedStringArray) -> void:
	if not DirAccess.dir_exists_absolute(dir):
		complaints.append("the folder %s does not exist" % dir)
		return
	var files: PackedStringArray = DirAccess.get_files_at(dir)
	files.sort()
	for file: String in files:
		if file.begins_with(_values["prefix"]) and file.ends_with(_values["suffix"]):
			if dir.path_join(file) not in paths:
				paths.append(dir.path_join(file))
	if not _values["include_subdirs"]:
		return
	var folders: PackedStringArray = DirAccess.get_directories_at(dir)
	folders.sort()
	for folder: String in folders:
		var below: String = dir.path_join(folder)
		if not folder.begins_with(".") and not FileAccess.file_exists(below + "/.gdignore"):
			_find_scripts(below, paths)


func _collect_script(path: String) -> void:
	if not FileAccess.file_exists(path):
		complaints.append("the test script %s does not exist" % path)
		return
	var script: GDScript = load(path) as GDScript
	if script == null or not script.can_instantiate():
		complaints.append("the test script %s does not compile" % path)
		return
	if not _is_test(script):
		complaints.append("the test script %s does not extend GutTest" % path)
		return
	var name: String = path.trim_prefix("res://")
	var wanted_class: String = _values["inner_class"]
	if wanted_class.is_empty():
		_add_suite(name, script)
	var constants: Dictionary = script.get_script_constant_map()
	for constant: String in constants:
		if not constant.begins_with(INNER_PREFIX) or constants[constant] is not GDScript:
			continue
		var inner: GDScript = constants[constant]
		if not _is_test(inner):
			continue
		if wanted_class.is_empty() or wanted_class in constant:
			_add_suite("%s.%s" % [name, constant], inner)


func _add_suite(name: String, script: GDScript) -> void:
	var suite: Suite = Suite.new()
	suite.name = name
	suite.source = script
	var filter: String = _values["unit_test_name"]
	for method: Dictionary in script.get_script_method_list():
		var test: String = method["name"]
		if not test.begins_with(TEST_PREFIX) or test in suite.tests:
			continue
		if filter.is_empty() or filter in test:
			suite.tests.append(test)
	if not suite.tests.is_empty():
		suites.append(suite)


static func _is_test(script: GDScript) -> bool:
	var base: Script = script
	while base != null:
		if base.resource_path == BASE_SCRIPT:
			return true
		base = base.get_base_script()
	return false
