# SPDX-License-Identifier: MIT
@tool
extends "editor_case.gd"
## The editor's own 3D view shows the bent sky, and each change of a property in its next frame.

## Of the sky and of the disk: property and another value. All properties are looked at by
## tests/render/test_next_frame.gd; these go other ways to the graphics card.
const SKY: Dictionary[StringName, Variant] = {
	&"schwarzschild_radius": 0.2,
	&"exposure": 0.0,
	&"background": BlackHoleSky.BACKGROUND_GRID,
}
const DISK: Dictionary[StringName, Variant] = {&"outer_radius": 6.0}
## Lines of hole and disk fill more pixels than this.
const LINE_PIXELS: int = 1000
## Frames that the view gets to show an opened scene.
const SETTLE: int = 12


func test_changes_show_in_the_next_frame() -> void:
	await switch_plugin(true)
	var root := await _show("res://scenes/full.tscn")
	var sky: BlackHoleSky = root.get_node("Sky")
	await _expect_changes(sky, SKY)
	await _expect_changes(sky.get_node("Disk"), DISK)


func test_lines_are_drawn_over_the_sky() -> void:
	await switch_plugin(true)
	var root := EditorInterface.get_edited_scene_root()  # as the test before has left it
	EditorInterface.get_selection().clear()
	EditorInterface.inspect_object(root.get_node("Sky"))
	_press_in_menu("View Grid")
	_press_in_menu("View Origin")
	await frames(SETTLE)
	var window := tree.root.get_texture().get_image()
	window.save_png(OS.get_environment("BLACKHOLE_EDITOR_PICTURES").path_join("editor.png"))
	var with_lines := await _next_picture()
	await switch_plugin(false)
	await frames(2)
	var drawn := _changed_pixels(with_lines, await _next_picture())
	expect(drawn > LINE_PIXELS, "pixels of lines: %d" % drawn)
	# Godot 4.6 complains of any scene with an inspected node that is open at the end.
	EditorInterface.get_selection().clear()
	while EditorInterface.get_edited_scene_root() != null:
		EditorInterface.close_scene()
		await frames(3)


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
		var history := EditorInterface.get_editor_undo_redo()
		history.create_action("Set %s" % property, UndoRedo.MERGE_DISABLE, node)
		history.add_do_property(node, property, changes[property])
		history.add_undo_property(node, property, usual)
		history.commit_action()
		expect(_differ(before, await _next_picture()), "%s shows" % property)
		await self.undo(node)
		expect(not _differ(before, await _next_picture()), "%s is undone" % property)


## The view after this frame; the editor draws none while it believes that nothing has changed.
func _next_picture() -> Image:
	await tree.process_frame
	return EditorInterface.get_editor_viewport_3d().get_texture().get_image()


func _press_in_menu(text: String) -> void:
	var window := EditorInterface.get_base_control()
	for node: Node in window.find_children("*", "PopupMenu", true, false):
		var menu: PopupMenu = node
		for item in menu.item_count:
			if menu.get_item_text(item) == text:
				menu.id_pressed.emit(menu.get_item_id(item))
				return
	expect(false, "there is no menu item " + text)


func _changed_pixels(one: Image, other: Image) -> int:
	var changed := 0
	for y in one.get_height():
		for x in one.get_width():
			var change := one.get_pixel(x, y) - other.get_pixel(x, y)
			changed += 1 if absf(change.r) + absf(change.g) + absf(change.b) > 0.1 else 0
	return changed


func _differ(one: Image, other: Image) -> bool:
	return one.get_data() != other.get_data()
