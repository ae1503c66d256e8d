# SPDX-License-Identifier: MIT
class_name TestRoom
extends RefCounted
## A room to be captured: a sphere round the hole whose inside shines as a shader says, on the
## second render layer.

const LAYER: int = 2
const RADIUS: float = 40.0
const CODE: String = """
shader_type spatial;
render_mode unshaded, cull_disabled, fog_disabled, shadows_disabled;
#include "res://addons/blackhole_sky/shaders/scene_output.gdshaderinc"
uniform vec3 middle;
varying vec3 place;
%s
void vertex() {
	place = (MODEL_MATRIX * vec4(VERTEX, 1.0)).xyz;
}
void fragment() {
	ALBEDO = scene_output(shine(normalize(place - middle)));
}
"""


## A room about `middle`; `light`: the body of `vec3 shine(vec3 direction)`.
static func make(light: String, middle := Vector3.ZERO) -> MeshInstance3D:
	var room := MeshInstance3D.new()
	var sphere := SphereMesh.new()
	sphere.radius = RADIUS
	sphere.height = 2.0 * RADIUS
	room.mesh = sphere
	room.layers = LAYER
	room.position = middle
	relight(room, light)
	return room


static func relight(room: MeshInstance3D, light: String) -> void:
	var material := ShaderMaterial.new()
	material.shader = Shader.new()
	material.shader.code = CODE % ("vec3 shine(vec3 direction) { %s }" % light)
	material.set_shader_parameter("middle", room.position)
	room.material_override = material
