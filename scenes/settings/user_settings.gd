# SPDX-License-Identifier: MIT
class_name UserSettings
extends Node
## What the user has set. Loaded when it enters the tree, kept in a file soon after each change.

signal changed(key: StringName)

## Seconds without a change after which the file is written.
const PATIENCE: float = 0.5

## Where the values are kept; nowhere when empty.
@export var file: String = "user://settings.json"

## What was wrong in the file, in sentences; empty when nothing was.
var faults: Array[String] = []

var _values: Dictionary[StringName, Variant] = {}
var _unsaved: bool = false
var _rested: float = 0.0


func _init() -> void:
	process_mode = Node.PROCESS_MODE_ALWAYS


# Before anybody's _ready, which may want to know.
func _enter_tree() -> void:
	reload()


func _process(delta: float) -> void:
	_rested += delta
	if _unsaved and _rested >= PATIENCE:
		save()


func _notification(what: int) -> void:
	if what == NOTIFICATION_EXIT_TREE or what == NOTIFICATION_WM_CLOSE_REQUEST:
		save()


## Takes the values from the file; what is not there or wrong is as at first.
func reload() -> void:
	faults.clear()
	_unsaved = false
	_values.clear()
	for key in SettingList.keys():
		_values[key] = SettingList.find(key).initial
	if not file.is_empty():
		_values.merge(SettingsFile.read(file, faults), true)
	for sentence in faults:
		push_warning(sentence)


## Writes the file now, when something has changed.
func save() -> void:
	if not _unsaved:
		return
	_unsaved = false
	if not file.is_empty():
		SettingsFile.write(file, _values)


func get_value(key: StringName) -> Variant:
	return _values[key]


func is_on(key: StringName) -> bool:
	return _values[key] == true


func get_number(key: StringName) -> float:
	var number: float = _values[key]
	return number


func is_initial(key: StringName) -> bool:
	return _values[key] == SettingList.find(key).initial


## Sets a value; one that the setting does not take is refused.
func set_value(key: StringName, value: Variant) -> void:
	var setting := SettingList.find(key)
	if setting == null or not setting.takes(value):
		push_error("UserSettings: '%s' cannot be %s." % [key, value])
		return
	if _values[key] == value:
		return
	_values[key] = value
	_unsaved = true
	_rested = 0.0
	changed.emit(key)


## Sets all of a page as at first.
func reset_page(page: StringName) -> void:
	for setting in SettingList.of_page(page):
		set_value(setting.key, setting.initial)
