# SPDX-License-Identifier: MIT
class_name PointTarget
extends Node3D
## Something that hands and gazes can point at and choose: a panel, a ring, a button in the room.
## XrPointer asks those in its group for the nearest one that is hit and tells that one the rest.

const GROUP: StringName = &"xr_point_targets"


func _enter_tree() -> void:
	add_to_group(GROUP)


## Distance along the ray, in metres of the world, at which it is hit; INF when it is not. The ray
## begins at `from`; `direction` has length 1.
func distance_along(_from: Vector3, _direction: Vector3) -> float:
	return INF


## The same for one that is flat: a rectangle of `size` in its own plane, round its place, that is
## hit from the front.
func distance_to_flat(from: Vector3, direction: Vector3, size: Vector2) -> float:
	var normal := global_basis.z.normalized()
	var towards := direction.dot(normal)
	if towards > -1e-4:
		return INF
	var distance := (global_position - from).dot(normal) / towards
	if distance <= 0.0:
		return INF
	var place := to_local(from + direction * distance).abs()
	return distance if place.x <= 0.5 * size.x and place.y <= 0.5 * size.y else INF


## The ray rests on it, at a place in the world. Called each frame.
func point_at(_place: Vector3) -> void:
	pass


## The ray has gone elsewhere.
func leave() -> void:
	pass


## So long a gaze must rest on what is pointed at to choose it, seconds; INF: it cannot be chosen
## there. A change of `what_is_pointed_at()` starts the wait again.
func dwell_seconds() -> float:
	return INF


## Which of its parts is pointed at; null: none that can be chosen.
func what_is_pointed_at() -> Variant:
	return null


## The part that is pointed at is chosen. True when something came of it.
func choose() -> bool:
	return false


## The choosing button has been let go after choose().
func let_go() -> void:
	pass
