# SPDX-License-Identifier: MIT
@tool
extends EditorPlugin
## Prints the options that the editor knows for each export preset of the project, and ends it:
## `preset NAME` and `option KEY`, a line each.

## Until the editor has asked for options, which is how platforms become known here.
const FRAMES: int = 30

var _platforms := Platforms.new()


func _enter_tree() -> void:
	add_export_plugin(_platforms)
	_tell.call_deferred()


func _exit_tree() -> void:
	remove_export_plugin(_platforms)


func _tell() -> void:
	for i in FRAMES:
		await get_tree().process_frame
	for platform in _platforms.found:
		for preset: EditorExportPreset in platform.get_current_presets():
			print("preset ", preset.get_preset_name())
			for property in preset.get_property_list():
				print("option ", property["name"])
	get_tree().quit()


class Platforms:
	extends EditorExportPlugin
	var found: Array[EditorExportPlatform] = []

	func _get_name() -> String:
		return "Preset keys"

	func _get_export_options(platform: EditorExportPlatform) -> Array[Dictionary]:
		if not found.has(platform):
			found.append(platform)
		return []
