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


## The world direction, a unit vector, that is seen at a place of the picture.
func to_direction(pixel: Vector2) -> Vector3:
	var ndc := Vector2(2.0 * pixel.x / size.x - 1.0, 1.0 - 2.0 * pixel.y / size.y)
	# Skewed to the side alone, as every eye's projection is.
	var x := (ndc.x + _projection.z.x) / _projection.x.x
	var y := (ndc.y + _projection.z.y) / _projection.y.y
	return (_to_eye.transposed() * Vector3(x, y, -1.0)).normalized()


## Is a place in the picture, `margin` pixels from its border at least?
func holds(pixel: Vector2, margin: float) -> bool:
	return Rect2(Vector2.ZERO, size).grow(-margin).has_point(pixel)
