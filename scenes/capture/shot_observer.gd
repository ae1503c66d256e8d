# SPDX-License-Identifier: MIT
class_name ShotObserver
extends RefCounted
## How the eye of a shot moves, read from the shot's "observer" and checked against its place: no
## motion that general relativity does not allow there.

## In the order of LensingTable.Motion.
const MOTIONS: PackedStringArray = ["static", "rain", "infall", "orbit", "velocity"]
## Circular geodesics of a particle with mass end at the photon sphere.
const PHOTON_SPHERE: float = 1.5
## Slack for what one asks at the very turning point, of the size of its rounding.
const ROUNDING: float = 1e-12

var motion: LensingTable.Motion = LensingTable.MOTION_STATIC
## Of an infall: energy at infinity per rest energy, above 0; from rest at R it is sqrt(1 - 1/R).
var energy: float = 1.0
## Of an infall: the radius of rest in Schwarzschild radii, above 1; 0 when the energy was given.
var rest_radius: float = 0.0
## Of an infall: whether it goes outwards.
var outgoing: bool = false
## Of an orbit: the motion is right-handed about this direction; a unit vector in world axes.
var axis: PackedFloat64Array = [0.0, 1.0, 0.0]
## Of a given velocity: beta times the Lorentz factor, along world axes.
var celerity: PackedFloat64Array = [0.0, 0.0, 0.0]
## Of a given velocity: whether the static observer measures it, rather than rain.
var relative_to_static: bool = false
## Why the motion was refused; empty when it is fine.
var error: String = ""


## Reads what the schema has passed; `position` is the eye's place in Schwarzschild radii. Where
## there is no hole, the place does not matter, and a velocity is one relative to the stars.
static func from_data(
	data: Variant, position: PackedFloat64Array, hole: bool = true
) -> ShotObserver:
	var observer := ShotObserver.new()
	var far_away: PackedFloat64Array = [INF, 0.0, 0.0]
	observer._read({"motion": data} if data is String else data, position if hole else far_away)
	return observer


## Is it at rest or on the way to or from the hole?
func is_radial() -> bool:
	return motion != LensingTable.MOTION_ORBIT and motion != LensingTable.MOTION_VELOCITY


## The same for the sky.
func to_sky_observer() -> SkyObserver:
	var observer := SkyObserver.new()
	observer.motion = motion
	observer.energy = energy
	observer.outgoing = outgoing
	observer.axis = Vec3D.to_vector3(axis)
	observer.celerity = Vec3D.to_vector3(celerity)
	observer.relative_to_static = relative_to_static
	return observer


## Direction towards the middle of the shadow, as the eye sees it.
func apparent_hole(position: PackedFloat64Array) -> PackedFloat64Array:
	var direction: Vector3 = to_sky_observer().shadow(Vec3D.to_vector3(position))["direction"]
	return [direction.x, direction.y, direction.z]


func _read(data: Dictionary, position: PackedFloat64Array) -> void:
	motion = MOTIONS.find(data["motion"]) as LensingTable.Motion
	var radius := Vec3D.length(position)
	match motion:
		LensingTable.MOTION_STATIC:
			if radius <= 1.0:
				var text := 'no observer can be static at %s, at or inside the horizon; choose "rain"'
				_refuse(text % _at(radius))
		LensingTable.MOTION_INFALL:
			_read_infall(data, radius)
		LensingTable.MOTION_ORBIT:
			_read_orbit(data, position)
		LensingTable.MOTION_VELOCITY:
			_read_velocity(data, radius)


func _read_infall(data: Dictionary, radius: float) -> void:
	outgoing = data.get("outgoing", false)
	rest_radius = data.get("rest_radius_rs", 0.0)
	energy = sqrt(1.0 - 1.0 / rest_radius) if rest_radius > 0.0 else float(data["energy"])
	# (dr/dtau)^2 = energy^2 - 1 + 1/r; see Misner, Thorne & Wheeler, Gravitation, section 25.5.
	if energy * energy - 1.0 + 1.0 / radius < -ROUNDING:
		if rest_radius > 0.0:
			var text := "who falls from rest at r = %s r_s never is at %s, farther out"
			_refuse(text % [JsonWords.value(rest_radius), _at(radius)])
		else:
			var least := JsonWords.value(sqrt(1.0 - 1.0 / radius))
			var text := "with an energy of %s nothing gets to %s; it takes at least %s"
			_refuse(text % [JsonWords.value(energy), _at(radius), least])
	elif outgoing and radius <= 1.0:
		_refuse("nothing moves outwards at %s, at or inside the horizon" % _at(radius))


func _read_orbit(data: Dictionary, position: PackedFloat64Array) -> void:
	axis = Vec3D.normalized(data.get("axis", axis))
	var radius := Vec3D.length(position)
	if radius <= PHOTON_SPHERE:
		_refuse("there is no circular orbit at %s; it takes more than 1.5" % _at(radius))
	elif Vec3D.sine(axis, position) < 1e-9:
		error = "observer.axis points along position_rs; choose one across it."


func _read_velocity(data: Dictionary, radius: float) -> void:
	relative_to_static = data.get("relative_to", "rain") == "static"
	if relative_to_static and radius <= 1.0:
		var text := 'no static observer is at %s to measure a velocity; let it be relative_to "rain"'
		_refuse(text % _at(radius))
		return
	if data.has("celerity"):
		celerity = data["celerity"]
		return
	var beta: PackedFloat64Array = data["beta"]
	var speed := Vec3D.length(beta)
	if speed >= 1.0:
		error = (
			"observer.beta is %s times the speed of light; it must stay below 1."
			% JsonWords.value(speed)
		)
		return
	celerity = Vec3D.scaled(beta, 1.0 / sqrt((1.0 - speed) * (1.0 + speed)))


func _at(radius: float) -> String:
	return "r = %s r_s" % JsonWords.value(radius)


func _refuse(reason: String) -> void:
	error = "observer: %s." % reason
