# SPDX-License-Identifier: MIT
class_name MenuScreen
extends Control
## A page that covers the picture while it is open: keyboard, mouse and gamepad go through it alike,
## and what cancels closes it.

signal opened
signal closed


func _unhandled_input(event: InputEvent) -> void:
	if visible and event.is_action_pressed(&"ui_cancel"):
		get_viewport().set_input_as_handled()
		close()


func open() -> void:
	if visible:
		return
	show()
	_on_open()
	opened.emit()
	var first := get_first_focus()
	if first != null:
		first.grab_focus()


func close() -> void:
	if not visible:
		return
	hide()
	_on_close()
	closed.emit()


## What has the focus when the page opens; null where there is nothing to choose.
func get_first_focus() -> Control:
	return find_next_valid_focus()


## For pages that fill themselves when they open.
func _on_open() -> void:
	pass


func _on_close() -> void:
	pass
