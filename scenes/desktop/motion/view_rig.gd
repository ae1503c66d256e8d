# SPDX-License-Identifier: MIT
class_name ViewRig
extends RefCounted
## Where the eye is and how it is turned, relative to the hole. Lengths in Schwarzschild radii,
## angles in radians.
##
## Every motion here is a rotation or a flow with a closed form, so that one long step ends where
## many short ones do: the frame rate changes nothing. There are no poles: the eye turns about its
## own axes. It never comes nearer than NEAREST nor goes farther than FARTHEST.

## The nearest and the farthest place of the eye, in Schwarzschild radii.
const NEAREST: float = 0.02
const FARTHEST: float = 1000.0
## Angles and lengths below are treated as none.
const TINY: float = 1e-9
## Longest flight in one step, in units of the distance's natural logarithm.
const LONGEST_FLIGHT: float = 4.0

var _position := Vector3(0.0, 0.0, 10.0)
var _orientation := Quaternion.IDENTITY


## Puts the eye at `position`, its axes turned by `orientation`.
func place(position: Vector3, orientation: Quaternion) -> void:
	_set_position(position)
	if orientation.is_finite() and orientation.length_squared() > TINY:
		_orientation = orientation.normalized()


## Puts the eye at `position`, looking at the hole; `up` is what is up in the picture.
func look_from(position: Vector3, up: Vector3) -> void:
	_set_position(position)
	var upward := up
	if upward.cross(_position).length() < TINY * FARTHEST:
		upward = Vector3.UP if absf(_position.normalized().y) < 0.9 else Vector3.BACK
	_orientation = Basis.looking_at(-_position, upward).get_rotation_quaternion()


func get_position() -> Vector3:
	return _position


func get_orientation() -> Quaternion:
	return _orientation


func get_distance() -> float:
	return _position.length()


## The camera's transform in a world whose unit is one metre.
func get_transform(schwarzschild_radius: float) -> Transform3D:
	return Transform3D(Basis(_orientation), _position * schwarzschild_radius)


## Puts the eye elsewhere; it stays turned as it is.
func move_to(position: Vector3) -> void:
	_set_position(position)


## Goes round the hole, keeping the distance and the side that is shown to it.
func orbit(to_the_right: float, upwards: float) -> void:
	revolve(_orientation * Vector3(-upwards, to_the_right, 0.0))


## Goes round the hole about an axis through it, whose length is the angle.
func revolve(axis: Vector3) -> void:
	var angle := axis.length()
	if not is_finite(angle) or angle < TINY:
		return
	var rotation := Quaternion(axis / angle, angle)
	var distance := get_distance()
	_set_position((rotation * _position).normalized() * distance)
	_orientation = (rotation * _orientation).normalized()


## Turns the eye where it is; `roll` turns its head to the right.
func turn(to_the_right: float, upwards: float, roll: float) -> void:
	var axis := Vector3(upwards, -to_the_right, -roll)
	var angle := axis.length()
	if not is_finite(angle) or angle < TINY:
		return
	_orientation = (_orientation * Quaternion(axis / angle, angle)).normalized()


## Multiplies the distance by e^-`amount`.
func approach(amount: float) -> void:
	if is_finite(amount):
		_set_position(_position * exp(clampf(-amount, -LONGEST_FLIGHT, LONGEST_FLIGHT)))


## Flies along the eye's axes (x right, y up, -z forward) at a speed that is proportional to the
## distance from the hole: straight at it, a flight of length s divides the distance by e^s.
##
## The path of x' = |x| w from x0 for the time 1: with the unit vector e along w,
## x = x0 + e (|x0| sinh |w| + (x0 . e) (cosh |w| - 1)). It is exact and misses the centre.
func fly(flight: Vector3) -> void:
	var length := flight.length()
	if not is_finite(length) or length < TINY:
		return
	var along := _orientation * (flight / length)
	length = minf(length, LONGEST_FLIGHT)
	var step := get_distance() * sinh(length) + _position.dot(along) * (cosh(length) - 1.0)
	_set_position(_position + along * step)


## Turns the eye by a `fraction` (0 to 1) of the angle that it looks away from the hole.
func face_hole(fraction: float) -> void:
	face(-_position.normalized(), fraction)


## Turns the eye by a `fraction` (0 to 1) of the angle that it looks away from a direction.
func face(direction: Vector3, fraction: float) -> void:
	var forward := _orientation * Vector3.FORWARD
	var axis := forward.cross(direction)
	var angle := atan2(axis.length(), forward.dot(direction))
	if angle < 1e-6:
		return
	if axis.length() < 1e-6:
		axis = _orientation * Vector3.UP
	var rotation := Quaternion(axis.normalized(), angle * clampf(fraction, 0.0, 1.0))
	_orientation = (rotation * _orientation).normalized()


func _set_position(position: Vector3) -> void:
	if not position.is_finite():
		return
	var distance := position.length()
	if distance < TINY:
		_position = _position.normalized() * NEAREST
	elif distance < NEAREST or distance > FARTHEST:
		_position = position * (clampf(distance, NEAREST, FARTHEST) / distance)
	else:
		_position = position
