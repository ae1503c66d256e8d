# SPDX-License-Identifier: MIT
class_name PlaceFigures
extends RefCounted
## What the cards say of the place where the eye is, by the exact solution.

## The stars of which deflection and magnification are told stand so far beside the point behind the
## hole, degrees.
const DEFLECTED_DEG: float = 20.0
const MAGNIFIED_DEG: float = 1.0
## A star so far beside the axis through eye and hole, radians, tells where a ring is.
const BESIDE: float = 1e-5
## A speed that is none, in units of c.
const AT_REST: float = 1e-6

var sky: BlackHoleSky
var camera: Camera3D
## May be null.
var disk: AccretionDisk

var _place := Vector3(0.0, 0.0, 10.0)
var _radius: float = 10.0
var _observer := SkyObserver.new()
# At rest where one can be, else falling freely.
var _radial := SkyObserver.new()
var _lines: Dictionary[StringName, Callable] = {
	&"deflection": _deflection,
	&"ring": _ring,
	&"second_ring": _second_ring,
	&"shadow": _shadow,
	&"photon_sphere": _photon_sphere,
	&"gravitational_shift": _gravitational_shift,
	&"doppler": _doppler,
	&"aberration": _aberration,
	&"magnification": _magnification,
	&"rain": _rain,
	&"orbit": _orbit,
	&"disk": _disk,
	&"spin": _spin,
}


func get_names() -> Array[StringName]:
	return _lines.keys()


## A sentence about the place; empty where there is nothing to say.
func line(figure: StringName) -> String:
	if not _lines.has(figure) or sky == null or camera == null:
		return ""
	if sky.lensing < ObserverChoice.NO_HOLE:
		return _translated("The hole is switched off.")
	_look()
	var text: String = _lines[figure].call()
	return text


func _look() -> void:
	var to_sky := sky.global_transform.orthonormalized().affine_inverse()
	_place = to_sky * camera.global_position / (sky.schwarzschild_radius * sky.lensing)
	_radius = _place.length()
	_radial.motion = LensingTable.MOTION_STATIC if _radius > 1.0 else LensingTable.MOTION_RAIN
	_observer = sky.observer if sky.observer != null else _radial
	if not _observer.get_refusal(_place).is_empty():
		_observer = _radial


func _deflection() -> String:
	var image := _radial.star_image(_place, _star(PI - deg_to_rad(DEFLECTED_DEG)), 0)
	return (
		_translated("Here a star 20° beside the hole's middle is seen at %s.") % _angle(image["xi"])
	)


func _ring() -> String:
	var angle := 2.0 * _ring_half_angle()
	return _translated("Here the ring is %s across.") % ReadoutText.angle(angle)


func _second_ring() -> String:
	var ring: float = _radial.star_image(_place, _star(BESIDE), 1)["xi"]
	var edge: float = _radial.shadow(_place)["half_angle"]
	return (
		_translated("Here the second ring is %s outside the shadow's edge.") % _angle(ring - edge)
	)


func _shadow() -> String:
	var half: float = _observer.shadow(_place)["half_angle"]
	return _translated("Here the shadow is %s across.") % ReadoutText.angle(2.0 * half)


func _photon_sphere() -> String:
	var text := _translated("You are at %s, outside the photon sphere.")
	if _radius < ShotObserver.PHOTON_SPHERE:
		text = _translated("You are at %s, inside the photon sphere.")
	return text % ReadoutText.distance(_radius)


func _gravitational_shift() -> String:
	if _radius <= 1.0:
		return _translated("Nobody rests here: the horizon is farther out.")
	var ratio := 1.0 / sqrt(1.0 - 1.0 / _radius)
	return (
		_translated("Here starlight has %s times its frequency, for who rests.")
		% ReadoutText.significant(ratio)
	)


func _doppler() -> String:
	var beta := _speed()
	if beta < AT_REST:
		return _translated("You are at rest: there is no shift by motion.")
	var ratio := sqrt((1.0 + beta) / (1.0 - beta))
	return (
		_translated("Your speed is %s: straight ahead %s times the frequency.")
		% [ReadoutText.speed(beta), ReadoutText.significant(ratio)]
	)


func _aberration() -> String:
	var beta := _speed()
	if beta < AT_REST:
		return _translated("You are at rest: the sky is not crowded.")
	return (
		_translated("Your speed is %s: half of the sky is within %s of the way ahead.")
		% [ReadoutText.speed(beta), ReadoutText.angle(acos(beta))]
	)


func _magnification() -> String:
	var image := _radial.star_image(_place, _star(PI - deg_to_rad(MAGNIFIED_DEG)), 0)
	return (
		_translated("Here a star 1° beside the point behind the hole is magnified %s times.")
		% ReadoutText.significant(image["magnification"])
	)


func _rain() -> String:
	var text := _translated("Rain passes here at %s times the speed of light.")
	if _radius <= 1.0:
		text = _translated("Here space falls inwards at %s times the speed of light.")
	return text % ReadoutText.significant(1.0 / sqrt(_radius))


func _orbit() -> String:
	if _radius <= ShotObserver.PHOTON_SPHERE:
		return _translated("There is no circular orbit here.")
	var text := _translated("Here an orbit has %s of the speed of light; it is stable.")
	if _radius < 3.0:
		text = _translated("Here an orbit has %s of the speed of light; it is unstable.")
	return text % ReadoutText.significant(sqrt(0.5 / (_radius - 1.0)))


func _disk() -> String:
	if disk == null or not disk.visible:
		return _translated("The disk is switched off.")
	var kelvin := ReadoutText.counted(disk.get_hottest_temperature())
	return _translated("The hottest ring shown has %s K.") % kelvin


func _spin() -> String:
	return _translated("Here a = 0: the horizon is at rₛ.")


# A direction so many radians from straight away from the hole, to a side.
func _star(angle: float, side: float = 0.0) -> Vector3:
	var outward := _place / _radius
	var across := outward.cross(Vector3.UP)
	if across.length() < 0.1:
		across = outward.cross(Vector3.RIGHT)
	across = across.normalized().rotated(outward, side)
	return outward * cos(angle) + across * sin(angle)


# For every observer the ring is a circle, which three points tell.
func _ring_half_angle() -> float:
	var points: Array[Vector3] = []
	for third in 3:
		var star := _star(PI - BESIDE, TAU * third / 3.0)
		var direction: Vector3 = _observer.star_image(_place, star, 0)["direction"]
		points.append(direction.normalized())
	var middle := (points[1] - points[0]).cross(points[2] - points[0]).normalized()
	var hole: Vector3 = _observer.shadow(_place)["direction"]
	if middle.dot(hole) < 0.0:
		middle = -middle
	return middle.angle_to(points[0])


# Relative to who rests here; inside the horizon to rain.
func _speed() -> float:
	return ObserverSpeed.of(_observer.celerity_at(_place), _place)


static func _angle(radians: float) -> String:
	return ReadoutText.angle(radians)


static func _translated(text: String) -> String:
	return TranslationServer.translate(text)
