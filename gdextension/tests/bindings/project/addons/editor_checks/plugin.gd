# SPDX-License-Identifier: MIT
## Checks what only the editor shows: configuration warnings, class help, reloading the library.
## Prints EDITOR CHECKS PASSED when all is well, and ends the editor.
@tool
extends EditorPlugin

const SCENE := "res://addons/editor_checks/probe_scene.tscn"
## So long the editor may take for one thing on a busy machine, and after so long it is asked
## again: what is asked of it while it starts may be forgotten.
const PATIENCE_MSEC := 60000
const ASKED_AGAIN_MSEC := 3000

var _failures: PackedStringArray = []


func _enter_tree() -> void:
	_run.call_deferred()


func _run() -> void:
	while EditorInterface.get_resource_filesystem().is_scanning():
		await get_tree().process_frame
	await _wait_for(
		func() -> bool: return EditorInterface.get_edited_scene_root() is ProbeNode,
		func() -> void: EditorInterface.open_scene_from_path(SCENE)
	)
	var node := EditorInterface.get_edited_scene_root() as ProbeNode
	if node == null:
		_finish("the scene did not open")
		return
	await _check_warning("Assign a resource.", true)
	node.resource = ProbeResource.new()
	await _check_warning("Assign a resource.", false)
	await _check_help("größer than ASCII")
	await _check_reload(node)
	node = null
	_finish()


# The warning is the tooltip of a button beside the node in the scene dock.
func _check_warning(text: String, wanted: bool) -> void:
	await _wait_for(func() -> bool: return _dock_shows(text) == wanted)
	if _dock_shows(text) != wanted:
		_failures.append('the warning "%s" should%s be shown' % [text, "" if wanted else " not"])


func _check_help(text: String) -> void:
	await _wait_for(
		func() -> bool: return _help_shows(text),
		func() -> void: EditorInterface.get_script_editor().goto_help("class_name:ProbeNode")
	)
	if not _help_shows(text):
		_failures.append('the class help does not show "%s"' % text)


func _help_shows(text: String) -> bool:
	var script_editor := EditorInterface.get_script_editor()
	for label: Node in script_editor.find_children("*", "RichTextLabel", true, false):
		if (label as RichTextLabel).get_parsed_text().contains(text):
			return true
	return false


# A reloaded library takes over the objects that exist; their properties are carried over.
# Connections to C++ methods would lead into the old library, so there are none.
func _check_reload(node: Node) -> void:
	var resource: Resource = node.get("resource")
	node.set("resource", null)
	resource.set("gain", 3.5)
	var status := GDExtensionManager.reload_extension("res://probe.gdextension")
	if status != GDExtensionManager.LOAD_STATUS_OK:
		_failures.append("reloading gives status %d" % status)
		return
	await get_tree().process_frame
	if resource.get("gain") != 3.5:
		_failures.append("after reloading, gain is %s, not 3.5" % resource.get("gain"))
	resource.call("set_gain", 4.5)
	if resource.call("get_gain") != 4.5:
		_failures.append("after reloading, the methods do not work")
	node.set("resource", resource)
	if node.get("resource") != resource:
		_failures.append("after reloading, the node does not take a resource")


func _dock_shows(text: String) -> bool:
	var base := EditorInterface.get_base_control()
	for editor: Node in base.find_children("*", "SceneTreeEditor", true, false):
		for found: Node in editor.find_children("*", "Tree", true, false):
			var item := (found as Tree).get_root()
			if item == null:
				continue
			for button: int in item.get_button_count(0):
				if item.get_button_tooltip_text(0, button).contains(text):
					return true
	return false


func _wait_for(condition: Callable, ask: Callable = Callable()) -> void:
	var begun := Time.get_ticks_msec()
	var asked := -ASKED_AGAIN_MSEC
	while not condition.call() and Time.get_ticks_msec() - begun < PATIENCE_MSEC:
		if ask.is_valid() and Time.get_ticks_msec() - asked >= ASKED_AGAIN_MSEC:
			ask.call()
			asked = Time.get_ticks_msec()
		await get_tree().process_frame


func _finish(failure: String = "") -> void:
	if not failure.is_empty():
		_failures.append(failure)
	for line: String in _failures:
		print("FAILED in the editor: ", line)
	if _failures.is_empty():
		print("EDITOR CHECKS PASSED")
	get_tree().quit(0 if _failures.is_empty() else 1)
