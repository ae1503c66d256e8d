# SPDX-License-Identifier: MIT
class_name SteadyPose
extends RefCounted
## A place and a direction of view that follow a head without its trembling, with the horizon level.
##
## Two delays one after the other: fast motions are taken out more firmly than by one of the same
## length, and the view never starts with a jerk.

## Sine of the angle to the horizontal from where on, and up to where, the head's own roll comes
## back: straight up and down there is no horizon.
const LEVEL_TO: float = 0.8
const FREE_FROM: float = 0.97

## Seconds that the view lags behind.
var seconds: float = 0.4

var _near_place := Vector3.ZERO
var _place := Vector3.ZERO
var _near_turn := Quaternion.IDENTITY
var _turn := Quaternion.IDENTITY


## Goes there at once.
func settle(place: Vector3, view: Basis, up: Vector3) -> void:
	_near_place = place
	_place = place
	_near_turn = levelled(view, up).get_rotation_quaternion()
	_turn = _near_turn


## Follows for so many seconds.
func follow(place: Vector3, view: Basis, up: Vector3, passed: float) -> void:
	var weight := 1.0 - exp(-passed / maxf(0.5 * seconds, 1e-4))
	_near_place = _near_place.lerp(place, weight)
	_place = _place.lerp(_near_place, weight)
	var wanted := levelled(view, up).get_rotation_quaternion()
	_near_turn = _near_turn.slerp(wanted, weight).normalized()
	_turn = _turn.slerp(_near_turn, weight).normalized()


func get_place() -> Vector3:
	return _place


func get_basis() -> Basis:
	return Basis(_turn)


## The same view without roll; `up` has length 1.
static func levelled(view: Basis, up: Vector3) -> Basis:
	var ahead := -view.z.normalized()
	var steep := absf(ahead.dot(up))
	var upward := view.y.normalized().lerp(up, 1.0 - smoothstep(LEVEL_TO, FREE_FROM, steep))
	if ahead.cross(upward).length() < 1e-3:
		upward = view.y
	return Basis.looking_at(ahead, upward)
