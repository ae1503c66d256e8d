# SPDX-License-Identifier: MIT
class_name Veil
extends MeshInstance3D
## Something over the whole picture of both eyes, whatever their projections; child of the camera.
## The visitor alone sees it. Invisible until it is asked for.

var _material := ShaderMaterial.new()


## Of several veils that with the higher `priority` lies over the others.
func _init(shader: Shader, priority: int) -> void:
	var quad := QuadMesh.new()
	quad.size = Vector2(2.0, 2.0)
	mesh = quad
	_material.shader = shader
	_material.render_priority = priority
	material_override = _material
	custom_aabb = AABB(Vector3.ONE * -1e4, Vector3.ONE * 2e4)
	cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF
	layers = 2
	visible = false
