# SPDX-License-Identifier: MIT
class_name Vignette
extends Veil
## Closes the field of view in while the visitor is moved: what flows past at the edge of sight is
## what makes sick.

const SHADER: Shader = preload("res://scenes/xr/comfort/vignette.gdshader")
## Seconds in which it closes, and opens again.
const CLOSING_SECONDS: float = 0.12
const OPENING_SECONDS: float = 0.5

@export var rig: XrRig
@export var comfort: Comfort

var _closing: float = 0.0


func _init() -> void:
	super(SHADER, Material.RENDER_PRIORITY_MAX - 2)


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
