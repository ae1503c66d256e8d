# SPDX-License-Identifier: MIT
@tool
extends RefCounted
## Bakes lensing tables for what is edited, keeps them in files, and hands them over in a way that
## can be undone.

const TableBake := preload("table_bake.gd")
const BAKE: String = "Bake Lensing Table"

var _bakes: Array[TableBake] = []


## Bakes into the file `path`; `client` (a LensingTable, a BlackHoleSky or null) gets it at the end.
func bake(client: Object, path: String) -> void:
	if bake_of(client) != null:
		return
	var made := TableBake.new(path, client)
	made.ended.connect(_on_ended)
	_bakes.append(made)
	made.start()


## The bake that goes on for a client, or null.
func bake_of(client: Object) -> TableBake:
	for made in _bakes:
		if is_instance_valid(made.client) == is_instance_valid(client) and made.client == client:
			return made
	return null


## Stops all.
func leave() -> void:
	for made in _bakes:
		made.ended.disconnect(_on_ended)
		made.cancel()
	_bakes.clear()


## The file in which a table lives; empty where it has none.
static func file_of(table: LensingTable) -> String:
	if table.resource_path.get_extension() == "lut":
		return table.resource_path
	return table.source_file


func _on_ended(made: TableBake, saved: bool) -> void:
	_bakes.erase(made)
	if not saved:
		return
	print("Black Hole Sky: lensing table written to %s." % made.path)
	_renew_loaded(made.path)
	if is_instance_valid(made.client):
		_hand_over(made)
	if made.path.begins_with("res://"):
		EditorInterface.get_resource_filesystem().update_file(made.path)


## A table that was loaded from the file before is to be that of the file now.
func _renew_loaded(path: String) -> void:
	if ResourceLoader.has_cached(path):
		var loaded := load(path) as LensingTable
		if loaded != null:
			loaded.load_file(path)


func _hand_over(made: TableBake) -> void:
	var sky := made.client as BlackHoleSky
	var table := made.client as LensingTable
	if table != null and file_of(table) == made.path:
		if table.resource_path != made.path:
			table.load_file(made.path)
	elif table != null:
		_set_undoably(table, &"source_file", made.path)
	elif sky != null:
		_set_undoably(sky, &"table", load(made.path))


func _set_undoably(object: Object, property: StringName, value: Variant) -> void:
	var undo := EditorInterface.get_editor_undo_redo()
	undo.create_action(BAKE, UndoRedo.MERGE_DISABLE, object)
	undo.add_do_property(object, property, value)
	undo.add_undo_property(object, property, object.get(property))
	undo.commit_action()
