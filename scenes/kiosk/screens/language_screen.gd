# SPDX-License-Identifier: MIT
class_name LanguageScreen
extends MenuScreen
## The visitor chooses a language by its own name.

signal chosen(locale: String)

var _buttons: Array[Button] = []
var _languages: PackedStringArray = []

@onready var _grid: VBoxContainer = %Grid
@onready var _title: Label = %Title


## Offers these languages.
func offer(languages: PackedStringArray) -> void:
	for button in _buttons:
		button.free()
	_buttons.clear()
	_languages = languages
	var titles: PackedStringArray = []
	for locale in languages:
		titles.append(TextIn.language("Choose a language", locale))
		var button := Button.new()
		button.text = LanguagePage.title(locale)
		button.auto_translate_mode = Node.AUTO_TRANSLATE_MODE_DISABLED
		button.custom_minimum_size = Vector2(380.0, 68.0)
		button.add_theme_font_size_override(&"font_size", 26)
		button.pressed.connect(chosen.emit.bind(locale))
		_grid.add_child(button)
		_buttons.append(button)
	_title.text = "  ·  ".join(titles)


## The language that is in use.
func get_first_focus() -> Control:
	var at := _languages.find(TranslationServer.get_locale())
	return _buttons[maxi(at, 0)] if not _buttons.is_empty() else null
