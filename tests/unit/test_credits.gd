# SPDX-License-Identifier: MIT
extends GutTest
## The credits name what has to be named, and can be read by keys alone.

const SCREEN: PackedScene = preload("res://scenes/menu/credits_screen.tscn")
const THEME: Theme = preload("res://scenes/desktop/hud/hud_theme.tres")
const NAMES: PackedStringArray = [
	"Hipparcos",
	"van Leeuwen 2007",
	"XHIP",
	"Olaf Frohn",
	"Mellinger",
	"Popst",
	"Godot Engine",
	"GLM",
	"Boost.Math",
	"zlib",
	"Black Hole Sky",
]
const SIZE := Vector2(1280.0, 720.0)

var _screen: CreditsScreen
var _scroll: ScrollContainer


func before_each() -> void:
	var room := Control.new()
	room.theme = THEME
	room.size = SIZE
	add_child_autofree(room)
	_screen = SCREEN.instantiate()
	room.add_child(_screen)
	_scroll = _screen.get_node("%Scroll")
	_screen.open()


func _all(entries: Array[CreditsEntry]) -> String:
	var text := ""
	for entry in entries:
		text += entry.title + "\n" + entry.text + "\n"
	return text


func _push(action: StringName) -> void:
	var event := InputEventAction.new()
	event.action = action
	event.pressed = true
	get_tree().root.push_input(event)


func test_everything_is_named() -> void:
	var text := _all(CreditsText.entries())
	for named in NAMES:
		assert_string_contains(text, named)


func test_the_licences_are_there_in_full() -> void:
	var text := _all(CreditsText.licences())
	assert_string_contains(text, "Permission is hereby granted, free of charge")
	assert_string_contains(text, "Redistributions in binary form must reproduce")
	assert_string_contains(text, "Copyright (c) 2015, Olaf Frohn")


func test_nothing_is_wider_than_the_page() -> void:
	await wait_process_frames(2)
	assert_lte(_screen.get_combined_minimum_size().x, SIZE.x)
	for label: Label in (_screen.get_node("%Entries") as Control).get_children():
		assert_lte(label.get_minimum_size().x, _scroll.size.x, label.text)


func test_the_licences_scroll_and_the_credits_come_back() -> void:
	var switch: Button = _screen.get_node("%Switch")
	switch.pressed.emit()
	var licences: RichTextLabel = _screen.get_node("%Licences")
	for frame in 200:
		if licences.is_finished():
			break
		await wait_process_frames(1)
	await wait_process_frames(3)
	assert_true(licences.visible)
	_push(&"ui_page_down")
	assert_gt(_scroll.scroll_vertical, 200)
	_push(&"ui_end")
	assert_gt(_scroll.scroll_vertical, 5000)
	_push(&"ui_home")
	assert_eq(_scroll.scroll_vertical, 0)
	Input.action_press(&"ui_down")
	await wait_seconds(0.3)
	Input.action_release(&"ui_down")
	assert_gt(_scroll.scroll_vertical, 0, "a held key scrolls")
	switch.pressed.emit()
	assert_false(licences.visible)
	assert_eq(_scroll.scroll_vertical, 0)


func test_keys_reach_both_buttons() -> void:
	await wait_process_frames(2)
	assert_true((_screen.get_node("%Close") as Button).has_focus())
	_push(&"ui_right")
	assert_true((_screen.get_node("%Switch") as Button).has_focus())
	_push(&"ui_cancel")
	assert_false(_screen.visible)
