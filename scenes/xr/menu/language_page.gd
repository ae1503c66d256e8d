# SPDX-License-Identifier: MIT
class_name LanguagePage
extends RefCounted
## The languages to choose from, each by its own name.

## What a language calls itself; one that is not here is called by its English name.
const OWN_NAMES: Dictionary[String, String] = {"en": "English", "de": "Deutsch"}
## The language of the texts in the scripts.
const SOURCE: String = "en"


## The source's language, then those that Languages adds, from several files each.
static func locales() -> PackedStringArray:
	var found: PackedStringArray = [SOURCE]
	for file in Languages.FILES:
		var locale := file.get_file().get_basename()
		if not found.has(locale):
			found.append(locale)
	return found


static func title(locale: String) -> String:
	return OWN_NAMES.get(locale, TranslationServer.get_language_name(locale))


static func items() -> Array[MenuItem]:
	var made: Array[MenuItem] = []
	for locale in locales():
		var item := MenuItem.action(
			StringName("language_" + locale), title(locale), _take.bind(locale)
		)
		made.append(item.showing(_is_present.bind(locale)))
	return made


static func _take(locale: String) -> void:
	TranslationServer.set_locale(locale)


static func _is_present(locale: String) -> bool:
	var present := TranslationServer.get_locale().get_slice("_", 0)
	return present == locale or (locale == SOURCE and not locales().has(present))
