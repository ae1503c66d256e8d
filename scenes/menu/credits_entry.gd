# SPDX-License-Identifier: MIT
class_name CreditsEntry
extends RefCounted
## What the program owes to somebody: a heading and a text, both in the language of the display.

var title: String
var text: String


func _init(heading: String, words: String) -> void:
	title = heading
	text = words
