# SPDX-License-Identifier: MIT
class_name StarLookupsCheck
extends SelfCheck
## Do shaders find the images of stars where the exact solution has them?

const LOOKUPS_SHADER: Shader = preload("res://scenes/self_test/shaders/star_lookups.gdshader")
const COUNT: int = 320
const ORDERS: int = 4
const COLUMNS: int = 5
## The tables are good to 1e-5 rad and 0.3 %; the rest is for the card's own rounding.
const MOST_RADIANS: float = 2e-5
const MOST_LIGHT: float = 0.005
const MOST_SHIFT: float = 2e-4

var questions: Array[LensQuestion] = []


func _init(rng_seed: int = 1) -> void:
	name = &"star_lookups"
	compares = "%d images of stars, from the inverse table, with the exact solution" % COUNT
	fault = "The vertex shader reads the lensing table wrongly or computes too coarsely."
	remedy = FIRST_THINGS_FIRST + newer_driver_or_renderer()
	var rng := RandomNumberGenerator.new()
	rng.seed = rng_seed
	for i in COUNT:
		var question := LensQuestion.anywhere(rng, i % LensQuestion.KINDS)
		question.direction = LensQuestion.somewhere(rng)
		@warning_ignore("integer_division")
		question.order = (i / LensQuestion.KINDS) % ORDERS
		questions.append(question)


func measure(stage: SelfTestStage, result: CheckResult) -> void:
	var material := ShaderMaterial.new()
	material.shader = LOOKUPS_SHADER
	material.set_shader_parameter("table", stage.tables.inverse)
	material.set_shader_parameter("questions", LensQuestion.texture_of(questions))
	var said: PackedFloat32Array = await stage.reader.read(material, COLUMNS, questions.size())
	for i in questions.size():
		var asked := questions[i]
		var exact: Dictionary = asked.observer.star_image(asked.place, asked.direction, asked.order)
		var at := COLUMNS * i
		var direction := Vector3(said[at], said[at + 1], said[at + 2])
		var towards: Vector3 = exact["direction"]
		var magnification: float = exact["magnification"]
		var redshift: float = exact["redshift"]
		var off := direction.angle_to(towards) if direction.length() > 0.5 else NAN
		result.compare("direction", off, MOST_RADIANS, "rad")
		result.compare("magnification", said[at + 3] / magnification - 1.0, MOST_LIGHT)
		result.compare("frequency ratio", said[at + 4] / redshift - 1.0, MOST_SHIFT)
