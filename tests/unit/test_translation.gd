# SPDX-License-Identifier: MIT
extends GutTest
## Every text of the scenes has its translation in every language, with the same places for values.

const FOLDERS: PackedStringArray = [
	"res://scenes/main/",
	"res://scenes/menu/",
	"res://scenes/desktop/",
	"res://scenes/settings/",
	"res://scenes/cards/",
	"res://scenes/tour/",
	"res://scenes/kiosk/",
	"res://scenes/xr/",
]
const TEXT_IN_SCRIPT: String = '(?:tr|_translated|translate)\\(\\s*"([^"]+)"'
const TEXT_IN_SCENE: String = '\\n(?:text|tooltip_text) = "([^"]+)"'
## Names and marks that are the same everywhere.
const ALIKE: PackedStringArray = ["Black Hole Sky", "Deutsch", "English"]

## Of each locale: its files.
var _translations: Dictionary[String, Array] = {}


func before_all() -> void:
	for file in Languages.FILES:
		assert_true(FileAccess.file_exists(file), "%s is there" % file)
		var translation := load(file) as Translation
		if translation != null:
			_translations.get_or_add(translation.locale, []).append(translation)


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
			found.append(hit.get_string(1).c_unescape())
	return found


func _help_texts() -> PackedStringArray:
	var texts := PackedStringArray()
	for row in HelpOverlay.ROWS:
		if not row.is_empty():
			var what: String = row[0]
			texts.append(what)
			for at in range(2, row.size()):
				var way: String = row[at]
				if not way.is_empty():
					texts.append(way)
	return texts


func _is_translated(text: String, files: Array) -> bool:
	if ALIKE.has(text) or not RegEx.create_from_string("[A-Za-z]{2}").search(text):
		return true
	return files.any(
		func(file: Translation) -> bool: return not String(file.get_message(text)).is_empty()
	)


func test_every_text_is_translated() -> void:
	var texts := _help_texts()
	for folder in FOLDERS:
		_texts(folder, texts)
	assert_gt(texts.size(), 200)
	assert_has(_translations, "de")
	for locale in _translations:
		for text in texts:
			assert_true(_is_translated(text, _translations[locale]), "%s: %s" % [locale, text])


func test_places_for_values_are_kept() -> void:
	for locale in _translations:
		for file: Translation in _translations[locale]:
			for text in file.get_message_list():
				var translation := String(file.get_message(text))
				for place: String in ["%s", "%d"]:
					assert_eq(translation.count(place), text.count(place), "%s: %s" % [place, text])
