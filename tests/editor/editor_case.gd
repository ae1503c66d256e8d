# SPDX-License-Identifier: MIT
@tool
extends RefCounted
## What tests in the editor have in common: saying what is wrong, and doing what a developer does.

const ADDON: String = "blackhole_sky"
const PLUGIN: String = "res://addons/blackhole_sky/plugin.gd"
## So many frames are given to what ends on a worker thread.
const PATIENCE: int = 2000

var failures: PackedStringArray = []
var tree: SceneTree


func _init(of_editor: SceneTree) -> void:
	tree = of_editor


## Notes a failure unless `right`.
func expect(right: bool, what: String) -> void:
	if not right:
		failures.append(what)


## Notes a failure unless the two are equal.
func expect_equal(found: Variant, wanted: Variant, what: String) -> void:
	if typeof(found) != typeof(wanted) or found != wanted:
		failures.append("%s: %s instead of %s" % [what, found, wanted])


## Waits for so many frames.
func frames(count: int) -> void:
	for frame in count:
		await tree.process_frame


## Waits until `done` says true, but not for ever.
func until(done: Callable, what: String) -> void:
	for frame in PATIENCE:
		if done.call():
			return
		await tree.process_frame
	failures.append("in vain waited for: " + what)


## Switches the addon's plugin, as the project settings do.
func switch_plugin(on: bool) -> void:
	if EditorInterface.is_plugin_enabled(ADDON) == on:
		return
	EditorInterface.set_plugin_enabled(ADDON, on)
	await frames(2)
	await scanned()  # importers that come or go make the editor look at all files again


## Waits until the editor has looked at all files.
func scanned() -> void:
	var files := EditorInterface.get_resource_filesystem()
	await until(func() -> bool: return not files.is_scanning(), "the scan's end")
	await frames(2)


## The addon's plugin; null while it is off.
func plugin() -> EditorPlugin:
	for node: Node in tree.root.find_children("*", "EditorPlugin", true, false):
		var script: Script = node.get_script()
		if script != null and script.resource_path == PLUGIN:
			return node
	return null


## Opens a scene, as it is in its file, and returns its root.
func open(path: String) -> Node:
	var was_open := path in EditorInterface.get_open_scenes()
	EditorInterface.open_scene_from_path(path)
	if was_open:
		EditorInterface.reload_scene_from_path(path)
	await frames(3)
	return EditorInterface.get_edited_scene_root()


## Adds a node to the edited scene, as the Scene dock does.
func add_to_scene(node: Node) -> void:
	var root := EditorInterface.get_edited_scene_root()
	var history := EditorInterface.get_editor_undo_redo()
	history.create_action("Create Node", UndoRedo.MERGE_DISABLE, root)
	history.add_do_method(root, &"add_child", node, true)
	history.add_do_method(node, &"set_owner", root)
	history.add_do_reference(node)
	history.add_undo_method(root, &"remove_child", node)
	history.commit_action()
	await frames(3)


## Undoes the last step of the history that an object belongs to.
func undo(object: Object) -> void:
	_history(object).undo()
	await frames(2)


## Does again what was undone.
func redo(object: Object) -> void:
	_history(object).redo()
	await frames(2)


## The button of the inspector with this text; null where there is none to be seen.
func inspector_button(text: String) -> Button:
	for node: Node in EditorInterface.get_inspector().find_children("*", "Button", true, false):
		var button: Button = node
		if button.text == text and button.visible:
			return button
	return null


func _history(object: Object) -> UndoRedo:
	var manager := EditorInterface.get_editor_undo_redo()
	return manager.get_history_undo_redo(manager.get_object_history_id(object))
