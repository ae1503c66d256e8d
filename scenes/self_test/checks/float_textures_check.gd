# SPDX-License-Identifier: MIT
class_name FloatTexturesCheck
extends SelfCheck
## Do textures hold 32-bit floats as they were sent?

const TEXELS_SHADER: Shader = preload("res://scenes/self_test/shaders/texels.gdshader")
## One unit in the last place of a 32-bit float.
const LIMIT: float = 1.2e-7


func _init() -> void:
	name = &"float_textures"
	compares = "each number of the three tables, read by a shader, with the number that was sent"
	fault = (
		"The card does not keep 32-bit float textures as they are:"
		+ " they are rounded, damaged or not supported."
	)
	remedy = (
		"Switch off savings of texture quality or precision in the driver's settings. "
		+ newer_driver_or_renderer()
	)


func measure(stage: SelfTestStage, result: CheckResult) -> void:
	var tables := stage.tables
	await _compare(stage, result, "inverse table", tables.inverse, tables.inverse_texels)
	await _compare(stage, result, "forward table", tables.forward, tables.forward_texels)
	await _compare(stage, result, "Planck table", tables.planck, tables.planck_texels)


func _compare(
	stage: SelfTestStage,
	result: CheckResult,
	what: String,
	texture: Texture2D,
	sent: PackedFloat32Array
) -> void:
	var material := ShaderMaterial.new()
	material.shader = TEXELS_SHADER
	material.set_shader_parameter("table", texture)
	var columns := 4 * texture.get_width()
	var held: PackedFloat32Array = await stage.reader.read(material, columns, texture.get_height())
	if held.size() != sent.size():
		result.object("The %s has %d numbers instead of %d." % [what, held.size(), sent.size()])
		return
	result.compare("relative error of the " + what, largest_error(held, sent), LIMIT)


## The largest relative difference.
static func largest_error(held: PackedFloat32Array, sent: PackedFloat32Array) -> float:
	var worst := 0.0
	if held == sent:
		return worst
	for i in sent.size():
		var error := absf(held[i] - sent[i]) / maxf(absf(sent[i]), 1e-30)
		if not error <= worst:
			worst = error
		if is_nan(error):
			return NAN
	return worst
