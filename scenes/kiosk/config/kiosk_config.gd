# SPDX-License-Identifier: MIT
class_name KioskConfig
extends RefCounted
## What a museum sets for the exhibit, read from one JSON file beside the program. What is wrong in
## it is told by name, and the default takes its place: the exhibit always starts.

const SCHEMA_FILE: String = "res://scenes/kiosk/config/kiosk.schema.json"
const FILE_NAME: String = "kiosk.json"
## On the command line, after --: where the file is.
const ARGUMENT: String = "--kiosk-config="
const LOG_FOLDER: String = "user://kiosk"

## Where it was looked for.
var path: String
## What is wrong in the file, a sentence each.
var complaints: PackedStringArray = []

var _values: Dictionary = {}


## Reads the file that belongs to this run of the program.
static func of_program() -> KioskConfig:
	var beside := OS.get_executable_path().get_base_dir() if not OS.has_feature("editor") else ""
	return from_file(find(CommandLine.of_program(), beside))


## Where the file is: named on the command line, else beside the program (`beside`, empty while the
## project runs in the engine), else in the folder of the program's own files.
static func find(arguments: PackedStringArray, beside: String) -> String:
	var named := CommandLine.value(arguments, ARGUMENT)
	if not named.is_empty():
		return named
	return (beside if not beside.is_empty() else "user://").path_join(FILE_NAME)


static func from_file(file: String) -> KioskConfig:
	if not FileAccess.file_exists(file):
		var missing := from_data({}, file)
		missing.complaints.append("There is no %s: all settings are the defaults." % file)
		return missing
	var written := BoundedText.from_file(file, AtomicFile.MOST_BYTES)
	if not written.error.is_empty():
		var unread := from_data({}, file)
		unread.complaints.append("%s %s All settings are the defaults." % [file, written.error])
		return unread
	var parser := JSON.new()
	if parser.parse(written.text) != OK or not parser.data is Dictionary:
		var broken := from_data({}, file)
		broken.complaints.append(
			(
				"%s is no JSON object (line %d: %s): correct it. All settings are the defaults."
				% [file, parser.get_error_line() + 1, parser.get_error_message()]
			)
		)
		return broken
	var data: Dictionary = parser.data
	return from_data(data, file)


static func from_data(data: Dictionary, file: String = "") -> KioskConfig:
	var config := KioskConfig.new()
	config.path = file
	config._take(data)
	config._correct_languages()
	config._correct_rest()
	return config


func text(key: String) -> String:
	return _values[key]


func number(key: String) -> float:
	return _values[key]


func whole(key: String) -> int:
	return roundi(number(key))


func flag(key: String) -> bool:
	return _values[key]


func list(key: String) -> PackedStringArray:
	var items: Array = _values[key]
	return PackedStringArray(items)


func get_pin() -> OperatorPin:
	return OperatorPin.from_setting(_values["pin"])


func get_log_folder() -> String:
	return text("log_folder") if not text("log_folder").is_empty() else LOG_FOLDER


func get_log_bytes() -> int:
	return roundi(number("log_megabytes") * 1e6)


## All settings as they are in effect, for the log; the PIN is not told.
func describe() -> String:
	var told := _values.duplicate()
	told["pin"] = "set" if get_pin().is_set() else "none"
	return JSON.stringify(told)


func _take(data: Dictionary) -> void:
	var schema: Dictionary = (load(SCHEMA_FILE) as JSON).data
	var keys: Dictionary = schema["properties"]
	for key: String in keys:
		var own: Dictionary = keys[key]
		_values[key] = own["default"]
		if data.has(key):
			_take_key(key, data[key], schema)
	for key: String in data:
		if not keys.has(key):
			_complain(key, "there is no such key; the keys are " + ", ".join(keys.keys()), "Remove")


func _take_key(key: String, value: Variant, schema: Dictionary) -> void:
	var keys: Dictionary = schema["properties"]
	var alone: Dictionary = schema.duplicate()
	alone["properties"] = {key: keys[key]}
	var fault := JsonSchema.from_data(alone).check({key: value})
	if fault.is_empty():
		_values[key] = value
	else:
		_complain(key, fault.trim_suffix("."))


func _correct_languages() -> void:
	var known := LanguagePage.locales()
	var kept: Array = []
	for language in list("languages"):
		if known.has(language):
			kept.append(language)
		else:
			_complain("languages", "there is no %s; there are %s" % [language, ", ".join(known)])
	_values["languages"] = kept if not kept.is_empty() else [LanguagePage.SOURCE]
	if not list("languages").has(text("language")):
		_complain("language", "%s is none of languages" % text("language"))
		_values["language"] = list("languages")[0]


func _correct_rest() -> void:
	var tour := text("tour")
	if not tour.is_empty() and not ResourceLoader.exists(tour):
		_complain("tour", "there is no %s" % tour)
		_values["tour"] = ""
	if OS.find_keycode_from_string(text("operator_hotkey")) == KEY_NONE:
		_complain("operator_hotkey", "%s is no key" % text("operator_hotkey"))
		_values["operator_hotkey"] = "Ctrl+Shift+F12"


func _complain(key: String, what: String, remedy: String = "Correct") -> void:
	var kept := "" if remedy == "Remove" else " until then it is %s."
	if not kept.is_empty():
		kept %= JsonWords.value(_values.get(key)) if key != "pin" else "empty"
	complaints.append("%s, key %s: %s. %s it;%s" % [path, key, what, remedy, kept])
