# SPDX-License-Identifier: MIT
@tool
extends "editor_case.gd"
## A sky that is newly added has its data at once; one that comes with its scene is left alone.

const HIPPARCOS: int = 118217


func test_a_new_sky_gets_its_data() -> void:
	await switch_plugin(true)
	await open("res://scenes/empty.tscn")
	var sky := BlackHoleSky.new()
	await add_to_scene(sky)
	_expect_data(sky)
	expect_equal(sky.exposure, 2.0, "exposure")
	await undo(sky)
	expect(sky.table == null and sky.catalogue == null and sky.panorama == null, "undone")
	expect_equal(sky.exposure, 0.0, "exposure undone")
	expect(sky.is_inside_tree(), "the node is still there")
	await redo(sky)
	_expect_data(sky)
	var root := EditorInterface.get_edited_scene_root()
	await undo(root)
	await undo(root)
	expect(not sky.is_inside_tree(), "the node's creation is undone")
	await redo(root)
	expect(sky.is_inside_tree() and sky.table == null, "it comes back as it was made")


func test_a_sky_of_an_opened_scene_stays_bare() -> void:
	await switch_plugin(true)
	var sky := (await open("res://scenes/bare.tscn")).get_node("Sky") as BlackHoleSky
	expect(sky.table == null and sky.catalogue == null, "left alone")
	EditorInterface.open_scene_from_path("res://scenes/empty.tscn")
	await frames(3)
	EditorInterface.open_scene_from_path("res://scenes/bare.tscn")
	await frames(3)
	sky = EditorInterface.get_edited_scene_root().get_node("Sky")
	expect(sky.table == null and sky.catalogue == null, "left alone behind its tab")


func test_the_button_gives_what_is_missing() -> void:
	await switch_plugin(true)
	var sky := (await open("res://scenes/bare.tscn")).get_node("Sky") as BlackHoleSky
	sky.exposure = 1.0
	EditorInterface.edit_node(sky)
	await frames(3)
	var button := inspector_button("Use Default Data")
	expect(button != null, "the button is there")
	if button != null:
		button.pressed.emit()
		_expect_data(sky)
		expect_equal(sky.exposure, 1.0, "exposure is the developer's")
		await frames(2)
		expect(not button.visible, "nothing is missing any more")
		await undo(sky)
		expect(sky.table == null, "undone")


func _expect_data(sky: BlackHoleSky) -> void:
	expect(sky.table != null and sky.table.is_ready(), "a table that is ready")
	var stars := sky.catalogue.get_star_count() if sky.catalogue != null else 0
	expect_equal(stars, HIPPARCOS, "stars")
	expect_equal(sky.background, BlackHoleSky.BACKGROUND_PANORAMA, "background")
	expect(sky.panorama != null, "a panorama")
	for warning in sky.get_warnings():
		expect(warning.contains("the editor's preview"), "warning: " + warning)
