# SPDX-License-Identifier: MIT
class_name Languages
extends Node
## Adds the scene's translations while it is there. The texts in the scripts are the English ones.

const FILES: PackedStringArray = [
	"res://scenes/desktop/locale/de.po",
	"res://scenes/menu/locale/de.po",
	"res://scenes/settings/locale/de.po",
	"res://scenes/desktop/photo/locale/de.po",
	"res://scenes/cards/locale/de.po",
	"res://scenes/tour/locale/de.po",
	"res://scenes/kiosk/locale/de.po",
]

var _translations: Array[Translation] = []


func _enter_tree() -> void:
	for file in FILES:
		if ResourceLoader.exists(file):
			var translation := load(file) as Translation
			TranslationServer.add_translation(translation)
			_translations.append(translation)


func _exit_tree() -> void:
	for translation in _translations:
		TranslationServer.remove_translation(translation)
	_translations.clear()
