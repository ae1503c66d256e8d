# SPDX-License-Identifier: MIT
class_name CircleFit
extends RefCounted
## The circle nearest to a set of points, by least squares of the distances.

var centre: Vector2 = Vector2.ZERO
var radius: float = 0.0
## Root mean square and largest distance of the points from the circle.
var rms: float = 0.0
var largest: float = 0.0


## Fits at least three points; with fewer, or points on a line, the radius is NAN.
static func of_points(points: PackedVector2Array) -> CircleFit:
	var fit: CircleFit = CircleFit.new()
	fit.radius = NAN
	if points.size() < 3:
		return fit
	for point: Vector2 in points:
		fit.centre += point / points.size()
	# Gauss-Newton from the mean; the radius follows from the centre.
	for step: int in 50:
		var moved: Vector2 = fit._step(points)
		if not moved.is_finite():
			fit.radius = NAN
			return fit
		if moved.length() < 1e-6:
			break
	fit._measure(points)
	return fit


## Moves the centre once and returns by how much.
func _step(points: PackedVector2Array) -> Vector2:
	var mean_direction: Vector2 = Vector2.ZERO
	var mean_distance: float = 0.0
	for point: Vector2 in points:
		mean_direction += centre.direction_to(point) / points.size()
		mean_distance += centre.distance_to(point) / points.size()
	# Normal equations of distance(point) - mean distance = 0, linear in the shift of the centre.
	var xx: float = 0.0
	var xy: float = 0.0
	var yy: float = 0.0
	var bx: float = 0.0
	var by: float = 0.0
	for point: Vector2 in points:
		var slope: Vector2 = centre.direction_to(point) - mean_direction
		var residual: float = centre.distance_to(point) - mean_distance
		xx += slope.x * slope.x
		xy += slope.x * slope.y
		yy += slope.y * slope.y
		bx += slope.x * residual
		by += slope.y * residual
	var determinant: float = xx * yy - xy * xy
	if determinant <= 1e-12 * xx * yy:
		return Vector2(NAN, NAN)
	var shift: Vector2 = Vector2(yy * bx - xy * by, xx * by - xy * bx) / determinant
	centre += shift
	return shift


func _measure(points: PackedVector2Array) -> void:
	radius = 0.0
	for point: Vector2 in points:
		radius += centre.distance_to(point) / points.size()
	var squares: float = 0.0
	for point: Vector2 in points:
		var residual: float = absf(centre.distance_to(point) - radius)
		squares += residual * residual
		largest = maxf(largest, residual)
	rms = sqrt(squares / points.size())
