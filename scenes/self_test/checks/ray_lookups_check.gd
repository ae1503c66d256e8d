# SPDX-License-Identifier: MIT
class_name RayLookupsCheck
extends SelfCheck
## Do shaders follow viewing directions to where the exact solution has them end?

const LOOKUPS_SHADER: Shader = preload("res://scenes/self_test/shaders/ray_lookups.gdshader")
const COUNT: int = 320
const COLUMNS: int = 6
## As an error of the viewing direction; half of it is what the tables are good for.
const MOST_RADIANS: float = 2e-5
const MOST_SHIFT: float = 2e-4
## Radians from the shadow's edge within which rounding decides whether a ray is the hole's.
const EDGE: float = 1e-4

var questions: Array[LensQuestion] = []


func _init(rng_seed: int = 2) -> void:
	name = &"ray_lookups"
	compares = "%d viewing directions, from the forward table, with the exact solution" % COUNT
	fault = "The fragment shader reads the lensing table wrongly or computes too coarsely."
	remedy = FIRST_THINGS_FIRST + newer_driver_or_renderer()
	var rng := RandomNumberGenerator.new()
	rng.seed = rng_seed
	for i in COUNT:
		var question := LensQuestion.anywhere(rng, i % LensQuestion.KINDS)
		question.direction = LensQuestion.somewhere(rng)
		if i % 2 == 0:
			question.direction = _near_the_shadow(question, rng)
		questions.append(question)


func measure(stage: SelfTestStage, result: CheckResult) -> void:
	var material := ShaderMaterial.new()
	material.shader = LOOKUPS_SHADER
	material.set_shader_parameter("table", stage.tables.forward)
	material.set_shader_parameter("questions", LensQuestion.texture_of(questions))
	var said: PackedFloat32Array = await stage.reader.read(material, COLUMNS, questions.size())
	var misjudged := 0
	for i in questions.size():
		var asked := questions[i]
		if absf(_angle_to_edge(asked)) < EDGE:
			continue
		var exact: Dictionary = asked.observer.trace(asked.place, asked.direction)
		var at := COLUMNS * i
		var captured: bool = exact["captured"]
		if captured != (said[at + 3] <= 0.0):
			misjudged += 1
		elif not captured:
			var end := Vector3(said[at], said[at + 1], said[at + 2])
			var sky: Vector3 = exact["sky_direction"]
			var redshift: float = exact["redshift"]
			var stretch := maxf(absf(said[at + 4]), 1.0)
			var off := end.angle_to(sky) / stretch if end.length() > 0.5 else NAN
			result.compare("direction", off, MOST_RADIANS, "rad")
			result.compare("frequency ratio", said[at + 5] / redshift - 1.0, MOST_SHIFT)
	result.compare("rays wrongly given to the hole or the sky", misjudged, 0.0)


## How far outside of the shadow a question looks.
func _angle_to_edge(question: LensQuestion) -> float:
	var shadow: Dictionary = question.observer.shadow(question.place)
	var centre: Vector3 = shadow["direction"]
	var edge: float = shadow["half_angle"]
	return question.direction.angle_to(centre) - edge


## A direction from the shadow's centre to twice its radius.
func _near_the_shadow(question: LensQuestion, rng: RandomNumberGenerator) -> Vector3:
	var shadow: Dictionary = question.observer.shadow(question.place)
	var centre: Vector3 = shadow["direction"]
	var edge: float = shadow["half_angle"]
	var aside := centre.cross(LensQuestion.somewhere(rng)).normalized()
	return centre.rotated(aside, minf(edge * rng.randf_range(0.5, 2.0), PI)).normalized()
