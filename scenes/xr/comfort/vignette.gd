# SPDX-License-Identifier: MIT
class_name Vignette
extends MeshInstance3D
## Closes the field of view in while the visitor is moved: what flows past at the edge of sight is
## what makes sick. Child of the camera.

const SHADER: Shader = preload("res://scenes/xr/comfort/vignette.gdshader")
## Seconds in which it closes, and opens again.
const CLOSING_SECONDS: float = 0.12
const OPENING_SECONDS: float = 0.5

@export var rig: XrRig
@export var comfort: Comfort

var _closing: float = 0.0
var _material := ShaderMaterial.new()


func _init() -> void:
	var quad := QuadMesh.new()
	quad.size = Vector2(2.0, 2.0)
	mesh = quad
	_material.shader = SHADER
	_material.render_priority = Material.RENDER_PRIORITY_MAX - 2
	material_override = _material
	custom_aabb = AABB(Vector3.ONE * -1e4, Vector3.ONE * 2e4)
	cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF
	layers = 2  # for the visitor alone
	visible = false


func _process(delta: float) -> void:
	follow(rig.get_motion() * comfort.vignette, delta)


## Lets `seconds` pass while the picture is asked to close in so far, 0 to 1.
func follow(asked: float, seconds: float) -> void:
	var time := CLOSING_SECONDS if asked > _closing else OPENING_SECONDS
	_closing = lerpf(asked, _closing, exp(-seconds / time))
	if _closing < 1e-3 and asked == 0.0:
		_closing = 0.0
	visible = _closing > 0.0
	if visible:
		_material.set_shader_parameter(&"closing", _closing)


## How far it is closed, 0 to 1.
func get_closing() -> float:
	return _closing
