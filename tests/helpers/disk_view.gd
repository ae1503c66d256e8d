# SPDX-License-Identifier: MIT
class_name DiskView
extends RefCounted
## An accretion disk and an eye beside it: where on the picture the exact solution puts its points.

## Of the grid on which points are looked for first, pixels.
const GRID: int = 16
const HALF_GRID: int = 8

var view: ExactView
var disk_basis: Basis
## Of samples of the picture, per order: pixel to (radius, azimuth).
var _samples: Array[Dictionary] = []


## The eye at `radius` r_s, `inclination` degrees from the disk's normal, looks at the hole it sees.
func _init(
	radius: float, inclination: float, motion: LensingTable.Motion, vertical_fov_deg: float
) -> void:
	disk_basis = Basis(Vector3(0.3, 1.0, -0.2).normalized(), 0.7) * Basis(Vector3.RIGHT, 0.4)
	var tilt := deg_to_rad(inclination)
	var outward := disk_basis * Vector3(sin(tilt) * cos(0.3), cos(tilt), sin(tilt) * sin(0.3))
	view = ExactView.new(outward * radius, motion)
	view.observer.axis = disk_basis.y
	view.vertical_fov_deg = vertical_fov_deg
	var hole: Vector3 = view.observer.shadow(view.place)["direction"]
	view.look_along(ExactView.doubled(hole), disk_basis.y)


## Radius and azimuth (radians, of the disk node's own axes) of the point seen at a pixel; radius 0
## where there is none.
func point_at(pixel: Vector2, order: int) -> Vector2:
	var seen := seen_at(pixel, order)
	if not seen["reached"]:
		return Vector2.ZERO
	var place: Vector3 = seen["place"]
	place = disk_basis.transposed() * place
	return Vector2(seen["radius"], atan2(-place.z, place.x))


## The same as SkyObserver.disk_point() has it.
func seen_at(pixel: Vector2, order: int) -> Dictionary:
	var direction := Vec3D.to_vector3(view.to_direction(pixel))
	return view.observer.disk_point(view.place, direction, disk_basis.y, order)


## Where the point at this radius and azimuth is seen; NOWHERE if it is not in the picture.
func pixel_of(radius: float, azimuth: float, order: int) -> Vector2:
	var best := ExactView.NOWHERE
	var nearest := INF
	var samples := _samples_of(order)
	for pixel: Vector2 in samples:
		var off := _off(samples[pixel], radius, azimuth)
		if off.length_squared() < nearest:
			nearest = off.length_squared()
			best = pixel
	for i in 20:
		if best == ExactView.NOWHERE or not view.holds(best, 1.0):
			return ExactView.NOWHERE
		var here := _off(point_at(best, order), radius, azimuth)
		if here == Vector2.INF:
			return ExactView.NOWHERE
		var h := 0.05
		var dx := (_off(point_at(best + Vector2(h, 0), order), radius, azimuth) - here) / h
		var dy := (_off(point_at(best + Vector2(0, h), order), radius, azimuth) - here) / h
		var determinant := dx.x * dy.y - dx.y * dy.x
		if not absf(determinant) > 1e-12:
			return ExactView.NOWHERE
		var step := (
			Vector2(dy.x * here.y - dy.y * here.x, dx.y * here.x - dx.x * here.y) / determinant
		)
		best += step.limit_length(GRID)
		if step.length() < 1e-3:
			return best
	return ExactView.NOWHERE


## Sine of the angle at which circle and radius of the disk cross on the picture at a pixel.
func crossing_sine(pixel: Vector2, order: int) -> float:
	var here := point_at(pixel, order)
	var beside := _off(point_at(pixel + Vector2(0.5, 0), order), here.x, here.y)
	var below := _off(point_at(pixel + Vector2(0, 0.5), order), here.x, here.y)
	var radial := Vector2(beside.x, below.x).normalized()
	return absf(radial.cross(Vector2(beside.y, below.y).normalized()))


func _off(point: Vector2, radius: float, azimuth: float) -> Vector2:
	if point.x <= 0.0:
		return Vector2.INF
	return Vector2(log(point.x / radius), angle_difference(azimuth, point.y))


func _samples_of(order: int) -> Dictionary:
	while _samples.size() <= order:
		var samples: Dictionary[Vector2, Vector2] = {}
		for y in range(HALF_GRID, view.size.y, GRID):
			for x in range(HALF_GRID, view.size.x, GRID):
				var point := point_at(Vector2(x, y), _samples.size())
				if point.x > 2.0 and point.x < 30.0:
					samples[Vector2(x, y)] = point
		_samples.append(samples)
	return _samples[order]
