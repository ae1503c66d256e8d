# SPDX-License-Identifier: MIT
class_name FallRide
extends Ride
## A fall along a radius, exact at every moment, through the horizon to where rides end.

## Of the square of the energy, 1 - 1/r at rest: rounding must not put the place above the turning
## point.
const HAIR: float = 2e-7

var _path := RadialFallPath.new()
var _outward: Vector3
var _proper_time: float = 0.0
var _end: float = 0.0
var _title: String


## Dropped from rest at `radius` in direction `outward`.
static func from_rest(radius: float, outward: Vector3) -> FallRide:
	var ride := new()
	ride._title = _translated("Fall from rest at %s") % ReadoutText.distance(radius)
	ride._begin(ride._path.start_from_rest(radius) if radius > 1.0 else FAILED, outward)
	return ride


## Coming from rest at infinity, from `radius` on.
static func as_rain(radius: float, outward: Vector3) -> FallRide:
	var ride := new()
	ride._title = _translated("Fall from infinity, from %s on") % ReadoutText.distance(radius)
	ride._begin(ride._path.start_with_energy(radius, 1.0), outward)
	return ride


func get_title() -> String:
	return _title


func get_place() -> Vector3:
	return _path.position_at(_proper_time, _outward)


func get_radius() -> float:
	return _path.radius_at(_proper_time)


func get_celerity() -> Vector3:
	return _path.celerity_at(_proper_time, _outward)


func get_proper_time() -> float:
	return _proper_time


func get_rain_time() -> float:
	return _path.rain_time_at(_proper_time)


## Seen straight back.
func get_far_clock_rate() -> float:
	return _path.far_clock_rate_at(_proper_time)


func advance(proper_time: float) -> bool:
	_proper_time = clampf(_proper_time + proper_time, 0.0, _end)
	return _proper_time > 0.0 and _proper_time < _end


## In the logarithm of the radius, so that all of the way can be told apart.
func get_progress() -> float:
	return progress_of(get_radius())


## How far along a radius is.
func progress_of(radius: float) -> float:
	var start := _path.get_start_radius()
	return clampf(log(start / radius) / log(start / NEAREST), 0.0, 1.0)


func seek(progress: float) -> void:
	var start := _path.get_start_radius()
	var radius := start * pow(NEAREST / start, clampf(progress, 0.0, 1.0))
	_proper_time = clampf(_path.proper_time_to(radius), 0.0, _end)


func set_motion(observer: SkyObserver) -> void:
	observer.motion = LensingTable.MOTION_INFALL
	observer.energy = sqrt(_path.get_energy() ** 2 + HAIR)
	observer.outgoing = false


func _begin(error: Error, outward: Vector3) -> void:
	if error != OK:
		refusal = _translated("A fall from rest starts outside the horizon.")
		return
	_outward = outward
	_end = _path.proper_time_to(NEAREST)
