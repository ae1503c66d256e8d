# SPDX-License-Identifier: MIT
extends RefCounted
## What to run and how: command line over configuration file over defaults.

const DEFAULT_CONFIG := "res://.gutconfig.json"
const HELP := "res://addons/gut/parts/help.txt"
const FAILURE_TYPES: Array[String] = ["engine", "gut", "push_error"]

## Command line option -> configuration key. The type of the key's default says what it takes.
const KEY_OF_OPTION: Dictionary[String, String] = {
	"-gdir": "dirs",
	"-ginclude_subdirs": "include_subdirs",
	"-gtest": "tests",
	"-gprefix": "prefix",
	"-gsuffix": "suffix",
	"-gselect": "selected",
	"-ginner_class": "inner_class",
	"-gunit_test_name": "unit_test_name",
	"-gexit": "should_exit",
	"-glog": "log_level",
	"-gjunit_xml_file": "junit_xml_file",
	"-gpre_run_script": "pre_run_script",
	"-gpost_run_script": "post_run_script",
	"-gdisable_colors": "disable_colors",
	"-gno_error_tracking": "no_error_tracking",
	"-gfailure_error_types": "failure_error_types",
}

## The value of every key. Filled with the defaults.
var values: Dictionary[String, Variant] = {
	"dirs": [],
	"include_subdirs": false,
	"tests": [],
	"prefix": "test_",
	"suffix": ".gd",
	"selected": "",
	"inner_class": "",
	"unit_test_name": "",
	"should_exit": true,
	"log_level": 1,
	"junit_xml_file": "",
	"pre_run_script": "",
	"post_run_script": "",
	"disable_colors": false,
	"no_error_tracking": false,
	"failure_error_types": FAILURE_TYPES,
}
## What is wrong with the command line or the configuration; empty when nothing is.
var error: String = ""
var wants_help: bool = false

var _config_path: String = DEFAULT_CONFIG
var _config_was_named: bool = false


## Reads the command line (anything that does not begin with -g is the engine's) and the
## configuration.
func read(arguments: PackedStringArray) -> void:
	var given: Dictionary[String, Variant] = _read_arguments(arguments)
	if error.is_empty() and not wants_help:
		_read_config()
	if error.is_empty():
		values.merge(given, true)


func _read_arguments(arguments: PackedStringArray) -> Dictionary[String, Variant]:
	var given: Dictionary[String, Variant] = {}
	var i: int = 0
	while i < arguments.size() and error.is_empty():
		var argument: String = arguments[i]
		i += 1
		if not argument.begins_with("-g"):
			continue
		var option: String = argument.get_slice("=", 0)
		var has_value: bool = "=" in argument
		var text: String = argument.substr(option.length() + 1) if has_value else ""
		if option == "-gh":
			wants_help = true
			continue
		var key: String = KEY_OF_OPTION.get(option, "")
		if option != "-gconfig" and key.is_empty():
			error = "unknown option %s (-gh lists the options)" % option
			break
		var is_flag: bool = not key.is_empty() and values[key] is bool
		if not has_value and not is_flag:
			if i >= arguments.size() or arguments[i].begins_with("-"):
				error = "option %s wants a value" % option
				break
			text = arguments[i]
			i += 1
		if option == "-gconfig":
			_config_path = text
			_config_was_named = true
		else:
			given[key] = _value_of(key, text, given.get(key, []))
	return given


func _value_of(key: String, text: String, earlier: Variant) -> Variant:
	var default_value: Variant = values[key]
	if default_value is bool:
		return text != "false"
	if default_value is int:
		if not text.is_valid_int():
			error = "%s must be a whole number, not '%s'" % [KEY_OF_OPTION.find_key(key), text]
		return text.to_int()
	if default_value is Array:
		var list: Array = earlier
		return list + Array(text.split(",", false))
	return text


func _read_config() -> void:
	if _config_path.is_empty():
		return
	if not FileAccess.file_exists(_config_path):
		if _config_was_named:
			error = "the configuration file %s does not exist" % _config_path
		return
	var json: JSON = JSON.new()
	if json.parse(FileAccess.get_file_as_string(_config_path)) != OK:
		var place: Array = [_config_path, json.get_error_line(), json.get_error_message()]
		error = "%s, line %d: %s" % place
		return
	if json.data is not Dictionary:
		error = "%s: the outermost value must be an object" % _config_path
		return
	var data: Dictionary = json.data
	for key: String in values:
		if data.has(key):
			_take(key, data[key])


func _take(key: String, value: Variant) -> void:
	# JSON has no whole numbers.
	if values[key] is int and value is float:
		values[key] = int(value)
	elif typeof(value) == typeof(values[key]):
		values[key] = value
	else:
		var types: Array = [_config_path, key, type_string(typeof(values[key]))]
		error = "%s: %s must be of type %s" % types
