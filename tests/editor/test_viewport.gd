# SPDX-License-Identifier: MIT
@tool
extends "editor_case.gd"
## The editor's own 3D view shows the bent sky, and each change of a property in its next frame.

## Of the sky and of the disk: property and another value.
const SKY: Dictionary[StringName, Variant] = {
	&"schwarzschild_radius": 0.7,
	&"lensing": 0.5,
	&"observer_motion": LensingTable.MOTION_RAIN,
	&"exposure": 3.0,
	&"stars_visible": false,
	&"background": BlackHoleSky.BACKGROUND_GRID,
	&"overlays": BlackHoleSky.OVERLAY_EINSTEIN_RINGS,
	&"redshift_map": true,
}
const DISK: Dictionary[StringName, Variant] = {
	&"outer_radius": 8.0,
	&"brightness_ev": -31.0,
	&"opacity": 0.3,
	&"look": AccretionDisk.LOOK_CHECKERBOARD,
	&"visible": false,
}
## Frames that the view gets to show an opened scene.
const SETTLE: int = 30


func test_changes_show_in_the_next_frame() -> void:
	await switch_plugin(true)
	var root := await _show("res://scenes/full.tscn")
	_keep("editor_viewport")
	var sky: BlackHoleSky = root.get_node("Sky")
	await _expect_changes(sky, SKY)
	await _expect_changes(sky.get_node("Disk"), DISK)


func test_the_whole_window() -> void:
	await switch_plugin(true)
	var root := await _show("res://scenes/full.tscn")
	var sky: BlackHoleSky = root.get_node("Sky")
	EditorInterface.get_selection().clear()
	EditorInterface.get_selection().add_node(sky)
	EditorInterface.edit_node(sky)
	await frames(SETTLE)
	var window := tree.root.get_texture().get_image()
	window.save_png(OS.get_environment("BLACKHOLE_EDITOR_PICTURES").path_join("editor_window.png"))
	expect(window.get_width() >= 1024, "the window is as large as asked")


func _show(scene: String) -> Node:
	EditorInterface.set_main_screen_editor("3D")
	var root := await open(scene)
	await frames(SETTLE)
	return root


func _expect_changes(node: Node3D, changes: Dictionary[StringName, Variant]) -> void:
	for property: StringName in changes:
		var usual: Variant = node.get(property)
		await frames(2)
		var before := await _next_picture()
		var undo := EditorInterface.get_editor_undo_redo()
		undo.create_action("Set %s" % property, UndoRedo.MERGE_DISABLE, node)
		undo.add_do_property(node, property, changes[property])
		undo.add_undo_property(node, property, usual)
		undo.commit_action()
		expect(_differ(before, await _next_picture()), "%s shows" % property)
		await self.undo(node)
		expect(not _differ(before, await _next_picture()), "%s is undone" % property)


func _next_picture() -> Image:
	await RenderingServer.frame_post_draw
	return EditorInterface.get_editor_viewport_3d().get_texture().get_image()


func _differ(one: Image, other: Image) -> bool:
	return one.get_data() != other.get_data()


func _keep(picture: String) -> void:
	var view := EditorInterface.get_editor_viewport_3d().get_texture().get_image()
	view.save_png(OS.get_environment("BLACKHOLE_EDITOR_PICTURES").path_join(picture + ".png"))
