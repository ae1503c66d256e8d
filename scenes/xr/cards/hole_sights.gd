# SPDX-License-Identifier: MIT
class_name HoleSights
extends RefCounted
## In which directions of the world an eye sees the hole's shadow and the Einstein ring, by the
## exact solution and for the observer that the sky draws.

## From here inwards there is nothing to point at beside the hole; in its radii.
const NEAREST: float = 1.05
## A star so far beside the point behind the hole, radians, tells where the ring is.
const BESIDE: float = 1e-3

var sky: BlackHoleSky
## Towards the middle of the shadow; length 1.
var centre := Vector3.FORWARD
## Half of the shadow's angle, radians.
var half_angle: float = 0.0

var _from_hole := Vector3.ZERO
var _observer: SkyObserver
var _resting := SkyObserver.new()
var _falling := SkyObserver.new()


func _init() -> void:
	_falling.motion = LensingTable.MOTION_RAIN


## Looks from a place in the world; false where there is no hole to be seen from outside.
func look_from(place: Vector3) -> bool:
	var radius := sky.schwarzschild_radius * sky.lensing
	var away := place - sky.global_position
	if radius <= 0.0 or away.length() < NEAREST * radius:
		return false
	_from_hole = _axes().inverse() * away / radius
	_observer = sky.observer if sky.observer != null else _resting
	if not _observer.get_refusal(_from_hole).is_empty():
		_observer = _falling
	var shadow := _observer.shadow(_from_hole)
	var direction: Vector3 = shadow["direction"]
	centre = (_axes() * direction).normalized()
	half_angle = shadow["half_angle"]
	return true


## The edge of the shadow, on the side to which a direction of the world leads from its middle.
func edge_towards(side: Vector3) -> Vector3:
	var across := (side - centre * side.dot(centre)).normalized()
	return centre * cos(half_angle) + across * sin(half_angle)


## The same for the ring as which a point straight behind the hole is seen.
func ring_towards(side: Vector3) -> Vector3:
	var outward := _from_hole.normalized()
	var across := _axes().inverse() * side
	across = (across - outward * across.dot(outward)).normalized()
	var star := (across * BESIDE - outward).normalized()
	var direction: Vector3 = _observer.star_image(_from_hole, star, 0)["direction"]
	return (_axes() * direction).normalized()


func _axes() -> Basis:
	return sky.global_basis.orthonormalized()
