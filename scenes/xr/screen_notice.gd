# SPDX-License-Identifier: MIT
class_name ScreenNotice
extends CanvasLayer
## A sentence in the middle of the desktop's window, for those who look after the exhibit.

@onready var _text: Label = %Text


func _ready() -> void:
	clear()


func show_text(text: String) -> void:
	_text.text = text
	visible = true


func clear() -> void:
	visible = false
