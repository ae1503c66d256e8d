# SPDX-License-Identifier: MIT
class_name CardLeader
extends Node3D
## A thin line from a card to what it is about, with a small ring at its end.

const SHADER: Shader = preload("res://scenes/xr/cards/card_panel.gdshader")
const COLOUR := Color(0.72, 0.83, 1.0, 0.8)
const NOTHING := Color(0.72, 0.83, 1.0, 0.0)
## As seen from the head, degrees.
const WIDTH: float = 0.26
const RING: float = 1.3
## A line shorter than this is left out.
const SHORTEST: float = 0.6

var _line := MeshInstance3D.new()
var _ring := MeshInstance3D.new()


func _init() -> void:
	for part: MeshInstance3D in [_line, _ring]:
		part.mesh = QuadMesh.new()
		part.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF
		var material := ShaderMaterial.new()
		material.shader = SHADER
		material.render_priority = 8
		part.material_override = material
		add_child(part)
	var line: ShaderMaterial = _line.material_override
	# Only its width counts: along the line it is the same everywhere.
	line.set_shader_parameter(&"extent", Vector2(100.0, 1.0))
	line.set_shader_parameter(&"corner", 0.0)
	line.set_shader_parameter(&"border", 0.0)
	line.set_shader_parameter(&"fill", COLOUR)
	var ring: ShaderMaterial = _ring.material_override
	ring.set_shader_parameter(&"extent", Vector2.ONE)
	ring.set_shader_parameter(&"corner", 0.5)
	ring.set_shader_parameter(&"border", 0.2)
	ring.set_shader_parameter(&"fill", NOTHING)
	ring.set_shader_parameter(&"edge", COLOUR)


## Leads from one place to another, for an eye; all of them in the parent's axes.
func lead(from: Vector3, to: Vector3, eye: Vector3) -> void:
	var away := eye.distance_to(to)
	var degree := away * PI / 180.0
	var facing := (eye - to) / maxf(away, 1e-6)
	var across := facing.cross(Vector3.UP if absf(facing.y) < 0.99 else Vector3.RIGHT).normalized()
	_ring.transform = Transform3D(
		across * RING * degree, facing.cross(across) * RING * degree, facing, to
	)
	# The line ends at the ring.
	var end := to + (from - to).limit_length(0.5 * RING * degree)
	var along := end - from
	_line.visible = from.distance_to(to) > SHORTEST * degree + 0.5 * RING * degree
	var aside := facing.cross(along).normalized()
	_line.transform = Transform3D(along, aside * WIDTH * degree, facing, 0.5 * (from + end))
