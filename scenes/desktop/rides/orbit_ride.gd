# SPDX-License-Identifier: MIT
class_name OrbitRide
extends Ride
## A circular orbit in free fall.

## The axis must not point along the place; below this sine of the angle between them it does.
const LEAST_SINE: float = 1e-3

var _path := CircularOrbitPath.new()
var _proper_time: float = 0.0


## From `place` on, right-handed about `axis`.
static func from(place: Vector3, axis: Vector3) -> OrbitRide:
	var ride := new()
	if place.length() <= 1.5:
		ride.refusal = _translated("There is no circular orbit here: it takes more than 1.5 rₛ.")
	elif axis.normalized().cross(place.normalized()).length() < LEAST_SINE:
		ride.refusal = _translated(
			"Turn the head first: an orbit goes round what is up in the picture."
		)
	else:
		ride._path.start(place, axis)
	return ride


func get_title() -> String:
	var text := _translated("Circular orbit at %s")
	if not is_stable():
		text = _translated("Unstable circular orbit at %s")
	return text % ReadoutText.distance(_path.get_radius())


func is_stable() -> bool:
	return _path.is_stable()


func get_place() -> Vector3:
	return _path.position_at(_proper_time)


func get_celerity() -> Vector3:
	return _path.celerity_at(_proper_time)


func get_proper_time() -> float:
	return _proper_time


func get_rain_time() -> float:
	return _path.rain_time_at(_proper_time)


## Seen straight away from the middle of the hole's shadow.
func get_far_clock_rate() -> float:
	var observer := SkyObserver.new()
	set_motion(observer)
	var shadow: Vector3 = observer.shadow(get_place())["direction"]
	return _path.far_clock_rate_at(_proper_time, -shadow)


func advance(proper_time: float) -> bool:
	_proper_time += proper_time
	return true


## Within the present turn.
func get_progress() -> float:
	return fposmod(_proper_time / _path.get_period(), 1.0)


func seek(progress: float) -> void:
	_proper_time += (progress - get_progress()) * _path.get_period()


func set_motion(observer: SkyObserver) -> void:
	observer.motion = LensingTable.MOTION_ORBIT
	observer.axis = _path.get_axis()
