# SPDX-License-Identifier: MIT
extends GutTest
## Every text of the scenes has its translation, with the same places for values.

const FOLDER: String = "res://scenes/desktop/"
const XR_FOLDER: String = "res://scenes/xr/"
const TEXT_IN_SCRIPT: String = '(?:tr|_translated|translate)\\(\\s*"([^"]+)"'
const TEXT_IN_SCENE: String = '\\ntext = "([^"]+)"'

var _german: Translation


func before_all() -> void:
	_german = load(FOLDER + "locale/de.po") as Translation


func _texts(folder: String, found: PackedStringArray) -> PackedStringArray:
	for entry in DirAccess.get_directories_at(folder):
		_texts(folder + entry + "/", found)
	for entry in DirAccess.get_files_at(folder):
		var pattern := ""
		if entry.ends_with(".gd"):
			pattern = TEXT_IN_SCRIPT
		elif entry.ends_with(".tscn"):
			pattern = TEXT_IN_SCENE
		else:
			continue
		var source := FileAccess.get_file_as_string(folder + entry)
		for hit in RegEx.create_from_string(pattern).search_all(source):
			found.append(hit.get_string(1))
	return found


func test_every_text_is_translated() -> void:
	var texts := _texts(FOLDER, PackedStringArray())
	assert_gt(texts.size(), 20)
	texts.append_array(_texts(XR_FOLDER, PackedStringArray()))
	for row in HelpOverlay.ROWS:
		if not row.is_empty():
			var what: String = row[0]
			texts.append(what)
			for at in range(2, row.size()):
				var way: String = row[at]
				if not way.is_empty():
					texts.append(way)
	for text in texts:
		assert_ne(_german.get_message(text), &"", text)


func test_places_for_values_are_kept() -> void:
	for text in _german.get_message_list():
		var translation := String(_german.get_message(text))
		for place: String in ["%s", "%d"]:
			assert_eq(translation.count(place), text.count(place), "%s in: %s" % [place, text])
