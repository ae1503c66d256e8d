# SPDX-License-Identifier: MIT
class_name EyeEdge
extends RefCounted
## A piece of a sharp edge in one eye's picture: where it must be, and where the picture has it.
##
## Edges are the zeros of a `measure`: func(place: Vector3, direction: Vector3) -> float, for an eye
## at a place of the world and a direction in which it looks; NAN where the edge's two sides are not
## seen. Its sign says which side is seen.

## Round a piece nothing but its two sides is seen, so far, pixels.
const CLEAR: float = 6.0
## So far along the normal the picture's edge is looked for, pixels; there its sides are even.
const REACH: float = 4.0
## And that of another place, pixels.
const FAR: float = 14.0
const STEP: float = 0.25
## Between the lines on which edges are looked for, pixels.
const LINES: int = 8
## Between two looks on a line, pixels.
const LOOKS: int = 4
## Sides that differ by less in luminance are no edge.
const CONTRAST: float = 0.1

## Where it must be.
var pixel: Vector2
## Of the edge in the picture, a unit vector to the side where the measure is positive.
var normal: Vector2


## All pieces that an eye at `eye.place` sees and that stand alone, about LINES pixels apart.
static func of_eye(eye: EyeView, measure: Callable) -> Array[EyeEdge]:
	var edges: Array[EyeEdge] = []
	for row in range(LINES, eye.size.y, LINES):
		_along(eye, measure, Vector2(0.5, row), Vector2(LOOKS, 0.0), edges)
	for column in range(LINES, eye.size.x, LINES):
		_along(eye, measure, Vector2(column, 0.5), Vector2(0.0, LOOKS), edges)
	return edges


## How far the picture's edge lies from where it must be, along the normal, pixels; INF where there
## is none within REACH.
func offset(picture: PictureMeasure) -> float:
	var dark := picture.sample(pixel - normal * REACH)
	var bright := picture.sample(pixel + normal * REACH)
	if absf(bright - dark) < CONTRAST:
		return INF
	var half := 0.5 * (dark + bright)
	var light := func(t: float) -> float:
		return (picture.sample(pixel + normal * t) - half) / (bright - dark)
	return _rise(light, REACH)


## How far the edge would lie from there, along the normal, for an eye that saw from `place`; FAR
## when it would be farther.
func shift(eye: EyeView, measure: Callable, place: Vector3) -> float:
	var seen := func(t: float) -> float:
		return measure.call(place, eye.to_direction(pixel + normal * t))
	return minf(absf(_rise(seen, FAR)), FAR)


# Where `value` rises through zero next to t = 0; INF where it does not within `reach`.
static func _rise(value: Callable, reach: float) -> float:
	var nearest := INF
	var before: float = value.call(-reach)
	for i in roundi(2.0 * reach / STEP):
		var t := -reach + (i + 1) * STEP
		var here: float = value.call(t)
		if before < 0.0 and here >= 0.0:
			var at := t - STEP * here / (here - before)
			nearest = at if absf(at) < absf(nearest) else nearest
		before = here
	return nearest


static func _along(
	eye: EyeView, measure: Callable, start: Vector2, step: Vector2, into: Array[EyeEdge]
) -> void:
	var at := start
	var before: float = measure.call(eye.place, eye.to_direction(at))
	while eye.holds(at, 0.0):
		at += step
		var here: float = measure.call(eye.place, eye.to_direction(at))
		if before * here < 0.0 and eye.holds(at, CLEAR + LOOKS + 1.0):
			var edge := _between(eye, measure, at - step, at, before < 0.0)
			var is_new := func(other: EyeEdge) -> bool:
				return other.pixel.distance_to(edge.pixel) > 0.5 * LINES
			if edge._is_alone(eye, measure) and into.all(is_new):
				into.append(edge)
		before = here


static func _between(
	eye: EyeView, measure: Callable, from: Vector2, to: Vector2, rises: bool
) -> EyeEdge:
	for i in 24:
		var middle := 0.5 * (from + to)
		var value: float = measure.call(eye.place, eye.to_direction(middle))
		if (value < 0.0) == rises:
			from = middle
		else:
			to = middle
	var edge := EyeEdge.new()
	edge.pixel = 0.5 * (from + to)
	var slope := Vector2.ZERO
	for axis in 2:
		var aside := Vector2.ZERO
		aside[axis] = 0.2
		var more: float = measure.call(eye.place, eye.to_direction(edge.pixel + aside))
		var less: float = measure.call(eye.place, eye.to_direction(edge.pixel - aside))
		slope[axis] = more - less
	edge.normal = slope.normalized()
	return edge


# Are the two sides seen on both hands, each in one piece, and no other edge near?
func _is_alone(eye: EyeView, measure: Callable) -> bool:
	if not normal.is_finite() or normal == Vector2.ZERO:
		return false
	for i in range(1, 7):
		for side: float in [-1.0, 1.0]:
			var at := pixel + normal * (side * CLEAR * i / 6.0)
			if not measure.call(eye.place, eye.to_direction(at)) * side > 0.0:
				return false
	var changes := 0
	var before := 1.0
	for i in range(1, 17):
		var at := pixel + normal.rotated(TAU * i / 16.0) * CLEAR
		var here: float = measure.call(eye.place, eye.to_direction(at))
		if is_nan(here):
			return false
		changes += 1 if before * here < 0.0 else 0
		before = here
	return changes == 2
