# SPDX-License-Identifier: MIT
class_name PointerMarks
extends Node3D
## What one sees of pointing: a thin beam from the hand, a dot where the ray ends, and round it a
## ring that fills while the gaze waits. Sizes are angles, so that both can be seen at any distance;
## nothing hides them but the veils of comfort.

const BEAM: Shader = preload("res://scenes/xr/pointing/beam.gdshader")
const CURSOR: Shader = preload("res://scenes/xr/pointing/cursor.gdshader")
## After what is pointed at has been drawn, and before the veils.
const PRIORITY: int = 110
## A beam that meets nothing ends here, metres.
const FREE_BEAM: float = 1.2
const BEAM_LENGTH: float = 4.0
## The cursor's quad in diameters of the ring.
const QUAD_RINGS: float = 1.2

## As the head sees them, degrees.
@export_range(0.2, 3.0, 0.1, "suffix:°") var dot_degrees: float = 0.6
@export_range(1.0, 6.0, 0.1, "suffix:°") var ring_degrees: float = 2.4
@export_range(0.05, 1.0, 0.05, "suffix:°") var beam_degrees: float = 0.45

var _beam: MeshInstance3D
var _cursor: MeshInstance3D
var _beam_look := ShaderMaterial.new()
var _cursor_look := ShaderMaterial.new()


func _init() -> void:
	_beam = _make(_beam_look, BEAM)
	_beam.custom_aabb = AABB(Vector3(-0.1, -0.1, -1.1), Vector3(0.2, 0.2, 1.2))
	_cursor = _make(_cursor_look, CURSOR)


## A beam from `from`; it meets something after `distance` metres, or nothing (INF).
func show_beam(from: Vector3, direction: Vector3, distance: float) -> void:
	var length := minf(distance, BEAM_LENGTH) if is_finite(distance) else FREE_BEAM
	# The mesh is 1 long and as wide as the shader makes it.
	var side := direction.cross(Vector3.UP)
	if side.length_squared() < 1e-6:
		side = Vector3.RIGHT
	side = side.normalized()
	_beam.global_transform = Transform3D(
		Basis(side, side.cross(direction), -direction * length), from
	)
	_beam_look.set_shader_parameter(&"half_angle", deg_to_rad(0.5 * beam_degrees))
	_beam_look.set_shader_parameter(&"fades", 1.0 if distance > BEAM_LENGTH else 0.45)
	_beam.visible = true


func hide_beam() -> void:
	_beam.visible = false


## The dot at `place`, turned to `head`; `fill` 0 to 1 is how full the ring is, below 0: no ring.
func show_cursor(place: Vector3, head: Node3D, fill: float) -> void:
	var back := head.global_position - place
	var distance := maxf(back.length(), 0.05)
	back = back.normalized() if back.length() > 1e-3 else head.global_basis.z
	var up := back.cross(head.global_basis.x).normalized()
	var size := 2.0 * distance * tan(deg_to_rad(0.5 * ring_degrees)) * QUAD_RINGS
	_cursor.global_transform = Transform3D(
		Basis(up.cross(back) * size, up * size, back * size), place
	)
	_cursor_look.set_shader_parameter(&"fill", fill)
	_cursor_look.set_shader_parameter(&"dot_share", dot_degrees / ring_degrees)
	_cursor.visible = true


func hide_cursor() -> void:
	_cursor.visible = false


## The ring's diameter in the world, metres.
func get_cursor_width() -> float:
	return _cursor.global_basis.get_scale().x / QUAD_RINGS


func _make(look: ShaderMaterial, shader: Shader) -> MeshInstance3D:
	look.shader = shader
	look.render_priority = PRIORITY
	var mark := MeshInstance3D.new()
	mark.mesh = QuadMesh.new()
	mark.material_override = look
	mark.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF
	mark.gi_mode = GeometryInstance3D.GI_MODE_DISABLED
	mark.visible = false
	add_child(mark)
	return mark
