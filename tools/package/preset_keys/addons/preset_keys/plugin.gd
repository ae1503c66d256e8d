# SPDX-License-Identifier: MIT
@tool
extends EditorPlugin
## Lets the editor write the project's export presets as it has read them, with every option that it
## knows and none that it does not, and ends it.

## Until the editor has asked for options, which is how platforms become known here.
const FRAMES: int = 30
## Of all platforms; set to what it is, so that the editor finds something to write.
const OPTION: StringName = &"custom_template/release"
## The editor writes a moment later.
const SECONDS: float = 2.0

var _platforms := Platforms.new()


func _enter_tree() -> void:
	add_export_plugin(_platforms)
	_write.call_deferred()


func _exit_tree() -> void:
	remove_export_plugin(_platforms)


func _write() -> void:
	for i in FRAMES:
		await get_tree().process_frame
	for platform in _platforms.found:
		for preset: EditorExportPreset in platform.get_current_presets():
			preset.set(OPTION, preset.get(OPTION))
	await get_tree().create_timer(SECONDS).timeout
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
