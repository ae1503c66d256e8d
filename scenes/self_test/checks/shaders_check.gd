# SPDX-License-Identifier: MIT
class_name ShadersCheck
extends SelfCheck
## Does every shader of the addon compile with this driver, and draw something?

const FOLDER: String = "res://addons/blackhole_sky/shaders/"

## The shaders that are compiled anew.
var paths := addon_shaders()


func _init() -> void:
	name = &"shaders"
	compares = "every shader of the addon, compiled anew by this driver, against one that draws"
	fault = "The graphics driver refuses a shader, so stars or background stay invisible."
	remedy = (
		newer_driver_or_renderer() + " Report what the engine says, with the name of the card."
	)


## All shaders of the addon, in an exported program too.
static func addon_shaders() -> PackedStringArray:
	var found: PackedStringArray = []
	for file in ResourceLoader.list_directory(FOLDER):
		if file.get_extension() == "gdshader":
			found.append(FOLDER.path_join(file))
	return found


func measure(stage: SelfTestStage, result: CheckResult) -> void:
	if paths.is_empty():
		result.object("There are no shaders in %s." % FOLDER)
	var unusable := 0
	for path in paths:
		var shader := (
			ResourceLoader.load(path, "Shader", ResourceLoader.CACHE_MODE_IGNORE) as Shader
		)
		if shader == null or shader.get_shader_uniform_list().is_empty():
			result.object("%s does not compile." % path.get_file())
			unusable += 1
			continue
		await _draw_with(stage, shader)
	result.compare("shaders that do not compile", unusable, 0.0)


## Draws with the shader alone: what the driver then says is heard by SelfTest.
func _draw_with(stage: SelfTestStage, shader: Shader) -> void:
	var quad := MeshInstance3D.new()
	quad.mesh = QuadMesh.new()
	quad.custom_aabb = AABB(Vector3.ONE * -1e6, Vector3.ONE * 2e6)
	var material := ShaderMaterial.new()
	material.shader = shader
	quad.material_override = material
	stage.viewport.add_child(quad)
	await stage.take()
	quad.free()
