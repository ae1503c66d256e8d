# SPDX-License-Identifier: MIT
class_name PlanckLookupsCheck
extends SelfCheck
## Do shaders find colour and luminance of black bodies as Planck's law has them?

const LOOKUPS_SHADER: Shader = preload("res://scenes/self_test/shaders/planck_lookups.gdshader")
const COUNT: int = 200
const COLUMNS: int = 4
const COOLEST: float = 500.0
const HOTTEST: float = 1e6
const MOST_COLOUR: float = 0.002
## In log2: 0.07 %.
const MOST_LOG2: float = 0.001

var temperatures: PackedFloat32Array = []


func _init() -> void:
	name = &"planck_lookups"
	compares = "colour and luminance at %d temperatures with Planck's law" % COUNT
	fault = "The vertex shader reads the Planck table wrongly: colour and light of stars are wrong."
	remedy = FIRST_THINGS_FIRST + newer_driver_or_renderer()
	for i in COUNT:
		temperatures.append(COOLEST * pow(HOTTEST / COOLEST, i / (COUNT - 1.0)))


func measure(stage: SelfTestStage, result: CheckResult) -> void:
	var asked: PackedFloat32Array = []
	for kelvin in temperatures:
		asked.append_array([kelvin, 0.0, 0.0, 0.0])
	var material := ShaderMaterial.new()
	material.shader = LOOKUPS_SHADER
	material.set_shader_parameter("table", stage.tables.planck)
	material.set_shader_parameter("questions", SelfTestTables.texture_of(asked, 1))
	var said: PackedFloat32Array = await stage.reader.read(material, COLUMNS, temperatures.size())
	for i in temperatures.size():
		var exact: Vector3 = BlackBody.colour(temperatures[i])
		for c in 3:
			result.compare("colour", said[COLUMNS * i + c] - exact[c], MOST_COLOUR)
		var log2_luminance := BlackBody.log2_luminance(temperatures[i])
		result.compare("log2 of luminance", said[COLUMNS * i + 3] - log2_luminance, MOST_LOG2)
