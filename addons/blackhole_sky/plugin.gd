# SPDX-License-Identifier: MIT
@tool
extends EditorPlugin
## Editor side of the addon: re-bakes the lensing table from the Tools menu.

const TABLE_FILE: String = "res://addons/blackhole_sky/data/schwarzschild.lut"
const MENU_ITEM: String = "Black Hole Sky: bake lensing table"

var _table: LensingTable


func _enter_tree() -> void:
	add_tool_menu_item(MENU_ITEM, _bake)


func _exit_tree() -> void:
	remove_tool_menu_item(MENU_ITEM)
	_table = null


func _bake() -> void:
	if _table != null and _table.is_baking():
		return
	_table = LensingTable.new()
	_table.bake_finished.connect(_save)
	_table.bake()


func _save(completed: bool) -> void:
	if completed and _table.save_file(TABLE_FILE) == OK:
		print("Black Hole Sky: lensing table written to %s." % TABLE_FILE)
