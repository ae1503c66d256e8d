# SPDX-License-Identifier: MIT
class_name Curtain
extends Veil
## A black veil before both eyes; several parts of the scene may ask for it, and the darkest wins.

const SHADER: Shader = preload("res://scenes/xr/comfort/curtain.gdshader")

var _asked: Dictionary[int, float] = {}


func _init() -> void:
	super(SHADER, Material.RENDER_PRIORITY_MAX - 1)


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
