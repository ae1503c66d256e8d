# SPDX-License-Identifier: MIT
@tool
extends RefCounted
## Circles as the line segments that gizmos are drawn from: pairs of points, closed.

const SEGMENTS: int = 96


## A circle about the origin in the plane of two orthogonal unit vectors; radius in the vectors'
## unit.
static func circle(radius: float, first: Vector3, second: Vector3) -> PackedVector3Array:
	return closed(
		func(turn: float) -> Vector3: return radius * (first * cos(turn) + second * sin(turn))
	)


## Three circles, one about each axis: a sphere to the eye.
static func sphere(radius: float) -> PackedVector3Array:
	var lines := circle(radius, Vector3.RIGHT, Vector3.UP)
	lines.append_array(circle(radius, Vector3.UP, Vector3.BACK))
	lines.append_array(circle(radius, Vector3.BACK, Vector3.RIGHT))
	return lines


## The closed line through `point_at` of an angle from 0 to a full turn.
static func closed(point_at: Callable) -> PackedVector3Array:
	var lines := PackedVector3Array()
	var before: Vector3 = point_at.call(0.0)
	for step in SEGMENTS:
		var point: Vector3 = point_at.call(TAU * (step + 1) / SEGMENTS)
		lines.append(before)
		lines.append(point)
		before = point
	return lines
