# SPDX-License-Identifier: MIT
@tool
extends "editor_case.gd"
## Switching the plugin on adds what it promises; switching it off leaves nothing.

const PAGE: String = "blackhole_sky/"
const CHANGED: String = "blackhole_sky/new_skies/magnitude_limit"
const MENU_ITEM: String = "Black Hole Sky: bake lensing table"


func test_on_and_off_leaves_no_trace() -> void:
	await switch_plugin(true)
	await switch_plugin(false)  # the engine has written the file in its own way once
	var before := FileAccess.get_file_as_bytes("res://project.godot")
	var nodes := _nodes()
	await switch_plugin(true)
	expect(plugin() != null, "the plugin is on")
	expect(_settings().size() > 4, "the page of project settings")
	expect(_menu_has_item(), "the item of the Tools menu")
	await switch_plugin(false)
	expect(plugin() == null, "the plugin is off")
	expect_equal(_settings(), PackedStringArray(), "settings left")
	expect(not _menu_has_item(), "the item of the Tools menu is gone")
	expect_equal(_nodes(), nodes, "nodes of the editor")
	var after := FileAccess.get_file_as_bytes("res://project.godot")
	expect(before == after, "project.godot is the same byte for byte")
	expect(not after.get_string_from_utf8().contains(PAGE), "project.godot has no setting of ours")


func test_what_the_developer_changed_stays() -> void:
	await switch_plugin(true)
	var usual: float = ProjectSettings.get_setting(CHANGED)
	ProjectSettings.set_setting(CHANGED, 7.0)
	await switch_plugin(false)
	expect_equal(_settings(), PackedStringArray([CHANGED]), "settings left")
	ProjectSettings.set_setting(CHANGED, usual)
	await switch_plugin(true)
	await switch_plugin(false)
	expect_equal(_settings(), PackedStringArray(), "settings left")


func _settings() -> PackedStringArray:
	var found := PackedStringArray()
	for property in ProjectSettings.get_property_list():
		var setting: String = property["name"]
		if setting.begins_with(PAGE):
			found.append(setting)
	return found


func _menu_has_item() -> bool:
	for node: Node in EditorInterface.get_base_control().find_children(
		"*", "PopupMenu", true, false
	):
		var menu: PopupMenu = node
		for item in menu.item_count:
			if menu.get_item_text(item) == MENU_ITEM:
				return true
	return false


func _nodes() -> int:
	return tree.get_node_count()
