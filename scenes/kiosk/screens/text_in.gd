# SPDX-License-Identifier: MIT
class_name TextIn
extends RefCounted
## Texts in one language while another is in use.

## Of each language the translations that were asked for.
static var _loaded: Dictionary[String, Array] = {}


## A text in a language; in English where the language has none.
static func language(text: String, locale: String) -> String:
	if not _loaded.has(locale):
		_loaded[locale] = _translations(locale)
	for translation: Translation in _loaded[locale]:
		var found := translation.get_message(text)
		if not found.is_empty():
			return found
	return text


static func _translations(locale: String) -> Array:
	var found: Array = []
	for file in Languages.FILES:
		if file.get_file().get_basename() == locale and ResourceLoader.exists(file):
			found.append(load(file))
	return found
