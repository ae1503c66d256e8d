# SPDX-License-Identifier: MIT
class_name Vec3D
extends RefCounted
## Three-vectors in double precision, for aiming cameras far from the hole: the engine's Vector3 has
## single precision.


static func length(a: PackedFloat64Array) -> float:
	return sqrt(dot(a, a))


static func dot(a: PackedFloat64Array, b: PackedFloat64Array) -> float:
	return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


static func add(a: PackedFloat64Array, b: PackedFloat64Array) -> PackedFloat64Array:
	return [a[0] + b[0], a[1] + b[1], a[2] + b[2]]


static func subtract(a: PackedFloat64Array, b: PackedFloat64Array) -> PackedFloat64Array:
	return [a[0] - b[0], a[1] - b[1], a[2] - b[2]]


static func scaled(a: PackedFloat64Array, factor: float) -> PackedFloat64Array:
	return [a[0] * factor, a[1] * factor, a[2] * factor]


static func cross(a: PackedFloat64Array, b: PackedFloat64Array) -> PackedFloat64Array:
	return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


static func normalized(a: PackedFloat64Array) -> PackedFloat64Array:
	return scaled(a, 1.0 / length(a))


## What is left of a vector without its part along a direction, a unit vector.
static func part_across(a: PackedFloat64Array, direction: PackedFloat64Array) -> PackedFloat64Array:
	return subtract(a, scaled(direction, dot(a, direction)))


## Sine of the angle between two vectors.
static func sine(a: PackedFloat64Array, b: PackedFloat64Array) -> float:
	return length(cross(a, b)) / (length(a) * length(b))


static func to_vector3(a: PackedFloat64Array) -> Vector3:
	return Vector3(a[0], a[1], a[2])
