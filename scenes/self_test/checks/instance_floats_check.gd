# SPDX-License-Identifier: MIT
class_name InstanceFloatsCheck
extends SelfCheck
## Do the transforms of instances, which hold the stars, arrive as 32-bit floats?

const BITS_SHADER: Shader = preload("res://scenes/self_test/shaders/instance_bits.gdshader")
const INSTANCES: int = 24
const FLOATS: int = 12
const BITS: int = 32
const LIMIT: float = 1.2e-7

## What must arrive, and what is sent: the same, unless a test damages it.
var expected: PackedFloat32Array = []
var sent: PackedFloat32Array = []


func _init(rng_seed: int = 3) -> void:
	name = &"instance_floats"
	compares = (
		"%d transforms of instances, as a vertex shader has them, with those sent" % INSTANCES
	)
	fault = (
		"Instance data are rounded, mixed up or missing:"
		+ " stars stand in wrong places, have wrong colours, or are not there."
	)
	remedy = newer_driver_or_renderer()
	var rng := RandomNumberGenerator.new()
	rng.seed = rng_seed
	for i in INSTANCES * FLOATS:
		# From the flux of the faintest stars to the temperature of the hottest.
		var size := exp(rng.randf_range(log(1e-8), log(1e5)))
		expected.append(size if rng.randf() < 0.5 else -size)
	sent = expected.duplicate()


func measure(stage: SelfTestStage, result: CheckResult) -> void:
	var stars := MultiMeshInstance3D.new()
	stars.multimesh = _instances()
	stars.custom_aabb = AABB(Vector3.ONE * -1e6, Vector3.ONE * 2e6)
	var material := ShaderMaterial.new()
	material.shader = BITS_SHADER
	material.set_shader_parameter("rows", INSTANCES)
	stars.material_override = material
	stage.sky.hide()
	stage.viewport.add_child(stars)
	stage.viewport.size = Vector2i(BITS * FLOATS, INSTANCES)
	var picture: Image = await stage.take()
	stage.viewport.size = SelfTestStage.SIZE
	stars.free()
	stage.sky.show()
	var arrived := floats_of(picture)
	result.compare("relative error", FloatTexturesCheck.largest_error(arrived, expected), LIMIT)


## A unit square for each instance, which the shader lays over the instance's row.
func _instances() -> MultiMesh:
	var arrays := []
	arrays.resize(Mesh.ARRAY_MAX)
	arrays[Mesh.ARRAY_VERTEX] = PackedVector3Array(
		[
			Vector3(0, 0, 0),
			Vector3(1, 0, 0),
			Vector3(1, 1, 0),
			Vector3(0, 0, 0),
			Vector3(1, 1, 0),
			Vector3(0, 1, 0),
		]
	)
	var square := ArrayMesh.new()
	square.add_surface_from_arrays(Mesh.PRIMITIVE_TRIANGLES, arrays)
	var instances := MultiMesh.new()
	instances.transform_format = MultiMesh.TRANSFORM_3D
	instances.mesh = square
	instances.instance_count = INSTANCES
	instances.buffer = sent
	return instances


## The floats whose bits a picture shows.
static func floats_of(picture: Image) -> PackedFloat32Array:
	var bytes: PackedByteArray = []
	for y in picture.get_height():
		@warning_ignore("integer_division")
		for byte in picture.get_width() / 8:
			var value := 0
			for bit in 8:
				if picture.get_pixel(8 * byte + bit, y).g > 0.5:
					value |= 1 << bit
			bytes.append(value)
	return bytes.to_float32_array()
