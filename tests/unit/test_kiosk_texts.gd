# SPDX-License-Identifier: MIT
extends GutTest
## Every text of the exhibit has its German, with the same places for values, and the health notice
## says what it must.

const FOLDER: String = "res://scenes/kiosk/"
const PATTERNS: Dictionary[String, String] = {
	"gd":
	'(?:tr\\(\\s*"([^"]+)"|const [A-Z_]+: String = "([A-Z][^"]+ [^"]+)"|^\t\t"([A-Z][a-z ]+)": )',
	"tscn": '(?m)^text = "([^"]+)"',
}


func _texts(folder: String, found: PackedStringArray) -> PackedStringArray:
	for entry in DirAccess.get_directories_at(folder):
		_texts(folder + entry + "/", found)
	for entry in DirAccess.get_files_at(folder):
		if PATTERNS.has(entry.get_extension()):
			var source := FileAccess.get_file_as_string(folder + entry)
			var pattern := RegEx.create_from_string("(?m)" + PATTERNS[entry.get_extension()])
			for hit in pattern.search_all(source):
				for group in range(1, hit.get_group_count() + 1):
					if not hit.get_string(group).is_empty():
						found.append(hit.get_string(group))
	return found


func test_every_text_is_translated() -> void:
	var texts := _texts(FOLDER, PackedStringArray())
	assert_gt(texts.size(), 40)
	for text in texts:
		var german := TextIn.language(text, "de")
		var is_alike := text in ["Renderer", "Version", "Headset"]
		assert_true(is_alike or german != text, text)
		for place: String in ["%s", "%d"]:
			assert_eq(german.count(place), text.count(place), text)


func test_a_language_that_is_not_there_is_english() -> void:
	assert_eq(TextIn.language("Begin", "tlh"), "Begin")
	assert_eq(TextIn.language("Begin", "en"), "Begin")
	assert_eq(TextIn.language("Begin", "de"), "Beginnen")


func test_the_health_notice_says_what_it_must() -> void:
	var page: Node = (load(FOLDER + "screens/health_screen.tscn") as PackedScene).instantiate()
	autofree(page)
	var words := ""
	for label: Label in page.find_children("Text", "Label", true, false):
		words += TextIn.language(label.text, "de") + label.text
	for word: String in ["13", "epilepsy", "Epilepsie", "pregnant", "Schwangerschaft", "unwell"]:
		assert_string_contains(words, word)
