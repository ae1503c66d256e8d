# SPDX-License-Identifier: MIT
class_name MenuCase
extends GutTest
## A test of the menu, in English unless it says otherwise: all languages are there, and the one of
## before comes back.

var _locale: String
var _languages: Languages


func before_all() -> void:
	_locale = TranslationServer.get_locale()
	_languages = Languages.new()
	add_child(_languages)


func before_each() -> void:
	TranslationServer.set_locale("en")


func after_all() -> void:
	_languages.free()
	TranslationServer.set_locale(_locale)
