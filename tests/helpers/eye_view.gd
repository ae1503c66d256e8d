# SPDX-License-Identifier: MIT
class_name EyeView
extends RefCounted
## One eye of a headset: where it is, and where on its picture a direction is seen.

const NOWHERE := Vector2(INF, INF)

## In the world.
var place: Vector3
var size: Vector2i

var _to_eye: Basis
var _projection: Projection


## The eye `view` (0 left, 1 right) of the session now.
func _init(scene: XrScene, view: int, picture_size: Vector2i) -> void:
	size = picture_size
	var interface := scene.session.get_interface()
	var origin := (scene.head.get_parent() as Node3D).global_transform
	var eye := interface.get_transform_for_view(view, origin)
	place = eye.origin
	_to_eye = eye.basis.orthonormalized().inverse()
	var aspect := float(size.x) / size.y
	_projection = interface.get_projection_for_view(view, aspect, scene.head.near, scene.head.far)


## Where a world direction is seen; NOWHERE when it is not before the eye.
func to_pixel(direction: Vector3) -> Vector2:
	var seen := _to_eye * direction
	if seen.z > -0.05:
		return NOWHERE
	var clip := _projection * Vector4(seen.x, seen.y, seen.z, 0.0)
	var ndc := Vector2(clip.x, clip.y) / clip.w
	return Vector2((0.5 + 0.5 * ndc.x) * size.x, (0.5 - 0.5 * ndc.y) * size.y)


## Is a place in the picture, `margin` pixels from its border at least?
func holds(pixel: Vector2, margin: float) -> bool:
	return Rect2(Vector2.ZERO, size).grow(-margin).has_point(pixel)
