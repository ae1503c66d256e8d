# SPDX-License-Identifier: MIT
@tool
extends RefCounted
## The orbits of observers who go round a hole: the innermost stable one, and that of each camera in
## the scene.

const CircleLines := preload("circle_lines.gd")

const INNERMOST_STABLE: float = 3.0
## Below there are no orbits, r_s.
const PHOTON_SPHERE: float = 1.5
## Length and half width of the arrow that shows the sense of motion, in radii of the orbit.
const ARROW: Vector2 = Vector2(0.12, 0.04)


## In the sky's axes and the units of `radius`, the hole's Schwarzschild radius; nothing for other
## motions.
static func of(sky: BlackHoleSky, radius: float) -> PackedVector3Array:
	var lines := PackedVector3Array()
	if sky.observer_motion != LensingTable.MOTION_ORBIT:
		return lines
	var axis := sky.observer.axis.normalized()
	lines.append_array(_orbit(INNERMOST_STABLE * _across(axis), axis))
	var to_sky := sky.global_transform.orthonormalized().affine_inverse()
	for camera: Camera3D in _cameras_beside(sky):
		lines.append_array(_orbit(to_sky * camera.global_position / radius, axis))
	return Transform3D(Basis.from_scale(Vector3.ONE * radius), Vector3.ZERO) * lines


static func _orbit(place: Vector3, axis: Vector3) -> PackedVector3Array:
	var has_orbit := place.length() > PHOTON_SPHERE and not place.cross(axis).is_zero_approx()
	var path := CircularOrbitPath.new()
	if not has_orbit or path.start(place, axis) != OK:
		return []
	var per_turn := path.get_period() / TAU
	var lines := CircleLines.closed(
		func(turn: float) -> Vector3: return path.position_at(per_turn * turn)
	)
	lines.append_array(_arrow(path))
	return lines


static func _arrow(path: CircularOrbitPath) -> PackedVector3Array:
	var tip := path.position_at(0.0)
	var along := path.get_axis().cross(tip)
	var side := ARROW.y * path.get_axis() * tip.length()
	var tail := tip - ARROW.x * along
	return [tip, tail + side, tip, tail - side]


static func _across(axis: Vector3) -> Vector3:
	var other := Vector3.RIGHT if absf(axis.x) < 0.9 else Vector3.BACK
	return axis.cross(other).normalized()


static func _cameras_beside(sky: BlackHoleSky) -> Array[Node]:
	var root: Node = sky.owner if sky.owner != null else sky
	return root.find_children("*", "Camera3D")
