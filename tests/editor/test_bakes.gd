# SPDX-License-Identifier: MIT
@tool
extends "editor_case.gd"
## Tables are baked on a worker into their file; a bake can be cancelled, and what it sets undone.

const OWN: String = "res://own.lut"
const ADDONS: String = "res://addons/blackhole_sky/data/schwarzschild.lut"


func test_bake_by_the_button() -> void:
	await switch_plugin(true)
	var table := await _inspected_table("res://made.lut")
	_press("Bake Table")
	await frames(1)
	expect(inspector_button("Cancel") != null, "there is a button to cancel")
	expect(inspector_button("Bake Table") == null, "one bake at a time")
	await until(func() -> bool: return inspector_button("Bake Table") != null, "the end")
	await frames(3)
	expect(table.is_ready(), "the table is ready")
	var made := FileAccess.get_file_as_bytes("res://made.lut")
	expect_equal(made.size(), FileAccess.get_file_as_bytes(ADDONS).size(), "size of the file")


func test_cancel() -> void:
	await switch_plugin(true)
	var table := await _inspected_table("res://cancelled.lut")
	_press("Bake Table")
	await frames(1)
	_press("Cancel")
	await until(func() -> bool: return inspector_button("Bake Table") != null, "the end")
	expect(not FileAccess.file_exists("res://cancelled.lut"), "no file was written")
	expect(not table.is_ready(), "the table is as it was")


func test_bake_for_a_sky_can_be_undone() -> void:
	await switch_plugin(true)
	var sky := (await open("res://scenes/bare.tscn")).get_node("Sky") as BlackHoleSky
	plugin().get("baker").call("bake", sky, OWN)
	await until(func() -> bool: return sky.table != null, "the table")
	expect(sky.table != null and sky.table.is_ready(), "the table is ready")
	expect_equal(sky.table.resource_path, OWN, "its file")
	await undo(sky)
	expect(sky.table == null, "undone")
	await redo(sky)
	expect(sky.table != null and sky.table.is_ready(), "done again")


func test_bake_for_a_table_without_file_can_be_undone() -> void:
	await switch_plugin(true)
	var sky := (await open("res://scenes/bare.tscn")).get_node("Sky") as BlackHoleSky
	sky.table = LensingTable.new()
	plugin().get("baker").call("bake", sky.table, "res://second.lut")
	await until(sky.table.is_ready, "the table")
	expect_equal(sky.table.source_file, "res://second.lut", "its file")
	await undo(sky.table)
	expect(not sky.table.is_ready(), "undone")
	await redo(sky.table)
	expect(sky.table.is_ready(), "done again")


func test_rebuild_reads_the_file_anew() -> void:
	await switch_plugin(true)
	DirAccess.copy_absolute(ADDONS, "res://rebuilt.lut")
	var table := LensingTable.new()
	table.source_file = "res://rebuilt.lut"
	var heard := [0]
	table.changed.connect(func() -> void: heard[0] += 1)
	EditorInterface.edit_resource(table)
	await frames(3)
	_press("Rebuild")
	expect_equal(heard[0], 1, "changes heard")
	expect(table.is_ready(), "the table is ready")


## A table that is to live in a file that is not there yet.
func _inspected_table(path: String) -> LensingTable:
	var table := LensingTable.new()
	table.take_over_path(path)
	EditorInterface.edit_resource(table)
	await frames(3)
	return table


func _press(text: String) -> void:
	var button := inspector_button(text)
	expect(button != null, "there is a button " + text)
	if button != null:
		button.pressed.emit()
