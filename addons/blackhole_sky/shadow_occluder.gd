# SPDX-License-Identifier: MIT
class_name ShadowOccluder
extends MeshInstance3D
## Keeps what stands behind the hole from showing through its shadow: objects of the scene are drawn
## where they are, unbent, and light from behind the hole does not come through.
##
## It covers the shadow as each camera and eye sees it, at the depth of the hole's middle; what is
## nearer stands before it. The picture does not change where no object is. Best a child of the sky,
## with which it is hidden then; its own place does not count. Objects outside of the shadow stay
## unbent.

const CORNERS: int = 16
const PAINT: Shader = preload("res://addons/blackhole_sky/shaders/shadow_occluder.gdshader")
const DEPTH: Shader = preload("res://addons/blackhole_sky/shaders/shadow_occluder_depth.gdshader")
## Before all of the sky's layers, and after them but before what is transparent elsewhere.
const PAINT_PRIORITY: int = -111
const DEPTH_PRIORITY: int = -80

## The hole; without one here it is that of the parent.
@export var sky: BlackHoleSky:
	set(value):
		_leave()
		sky = value
		_join()

var _paint := ShaderMaterial.new()
var _depth := ShaderMaterial.new()


func _init() -> void:
	_paint.shader = PAINT
	_paint.render_priority = PAINT_PRIORITY
	_paint.next_pass = _depth
	_depth.shader = DEPTH
	_depth.render_priority = DEPTH_PRIORITY
	mesh = _polygon()
	material_override = _paint
	custom_aabb = AABB(Vector3.ONE * -1e6, Vector3.ONE * 2e6)
	cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF


func _enter_tree() -> void:
	if sky == null:
		sky = get_parent() as BlackHoleSky
	_join()


func _exit_tree() -> void:
	_leave()


func _join() -> void:
	if sky != null and is_inside_tree():
		sky.add_material(_paint)
		sky.add_material(_depth)


func _leave() -> void:
	if sky != null:
		sky.remove_material(_paint)
		sky.remove_material(_depth)


static func _polygon() -> ArrayMesh:
	var corners := PackedVector3Array()
	for i in CORNERS:
		corners.append(Vector3.ZERO)
		for next: int in [i, i + 1]:
			var turn := TAU * next / CORNERS
			corners.append(Vector3(cos(turn), sin(turn), 0.0))
	var arrays: Array = []
	arrays.resize(Mesh.ARRAY_MAX)
	arrays[Mesh.ARRAY_VERTEX] = corners
	var polygon := ArrayMesh.new()
	polygon.add_surface_from_arrays(Mesh.PRIMITIVE_TRIANGLES, arrays)
	return polygon
