# SPDX-License-Identifier: MIT
class_name Curtain
extends MeshInstance3D
## A black veil before both eyes; several parts of the scene may ask for it, and the darkest wins.
##
## Child of the camera. It covers the picture of any projection, whatever the eyes' places.

const SHADER: Shader = preload("res://scenes/xr/comfort/curtain.gdshader")

var _asked: Dictionary[int, float] = {}
var _material := ShaderMaterial.new()


func _init() -> void:
	var quad := QuadMesh.new()
	quad.size = Vector2(2.0, 2.0)
	mesh = quad
	_material.shader = SHADER
	_material.render_priority = Material.RENDER_PRIORITY_MAX - 1
	material_override = _material
	custom_aabb = AABB(Vector3.ONE * -1e4, Vector3.ONE * 2e4)
	cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF
	layers = 2  # for the visitor alone
	visible = false


## `whom` asks for this darkness, 0 to 1, from now on.
func set_darkness(whom: Object, darkness: float) -> void:
	if is_equal_approx(_asked.get(whom.get_instance_id(), 0.0), darkness):
		return
	_asked[whom.get_instance_id()] = darkness
	var darkest := get_darkness()
	visible = darkest > 0.0
	_material.set_shader_parameter(&"darkness", darkest)


## The darkest that is asked for.
func get_darkness() -> float:
	var darkest := 0.0
	for asked: float in _asked.values():
		darkest = maxf(darkest, asked)
	return darkest
