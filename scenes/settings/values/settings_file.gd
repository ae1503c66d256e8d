# SPDX-License-Identifier: MIT
class_name SettingsFile
extends RefCounted
## Settings as a JSON file. Whatever is wrong in it is told, and only that is left out.

const DAMAGED: String = ".damaged.json"


## Reads the values of the file. `faults` gets a sentence for each thing that is wrong.
static func read(path: String, faults: Array[String]) -> Dictionary[StringName, Variant]:
	var text := AtomicFile.read(path, is_whole)
	_set_aside_if_damaged(path, not text.is_empty(), faults)
	if text.is_empty():
		return {}
	return parse(text, path, faults)


static func write(path: String, values: Dictionary[StringName, Variant]) -> Error:
	var named: Dictionary[String, Variant] = {}
	for key in values:
		named[String(key)] = values[key]
	return AtomicFile.write(path, JSON.stringify(named, "\t", false) + "\n")


## Whether the text is one whole JSON object.
static func is_whole(text: String) -> bool:
	var json := JSON.new()
	return not text.is_empty() and json.parse(text) == OK and json.data is Dictionary


## The values in a text that is whole.
static func parse(
	text: String, path: String, faults: Array[String]
) -> Dictionary[StringName, Variant]:
	var found: Dictionary = JSON.parse_string(text)
	var values: Dictionary[StringName, Variant] = {}
	for name: String in found:
		var setting := SettingList.find(name)
		if setting == null:
			faults.append(
				_translated("%s: nobody knows the setting '%s'. Remove it.") % [_shown(path), name]
			)
		elif not setting.takes(found[name]):
			faults.append(
				(
					_translated("%s: '%s' cannot be %s, but one of: %s. The default counts.")
					% [_shown(path), name, JsonWords.value(found[name]), setting.rule()]
				)
			)
		elif setting.kind == Setting.Kind.BINDINGS:
			var changes: Dictionary = found[name]
			var amiss: Array[String] = []
			values[name] = InputBindings.from_json(changes, amiss).to_json()
			for sentence in amiss:
				faults.append("%s: %s" % [_shown(path), sentence])
		else:
			values[name] = found[name]
	return values


static func _set_aside_if_damaged(path: String, rescued: bool, faults: Array[String]) -> void:
	if not FileAccess.file_exists(path):
		return
	if is_whole(BoundedText.from_file(path, AtomicFile.MOST_BYTES).text):
		return
	var aside := path.get_basename() + DAMAGED
	if DirAccess.rename_absolute(path, aside) != OK:
		aside = path
	var sentence := (
		_translated("%s is damaged and was put aside as %s: former settings count.")
		if rescued
		else _translated("%s is damaged and was put aside as %s: the settings start anew.")
	)
	faults.append(sentence % [_shown(path), aside.get_file()])


static func _shown(path: String) -> String:
	return ProjectSettings.globalize_path(path)


static func _translated(text: String) -> String:
	return TranslationServer.translate(text)
