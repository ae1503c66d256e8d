# SPDX-License-Identifier: MIT
class_name PilotedRide
extends Ride
## A flight with a rocket, along the true world line under the thrust that is asked for.

## Thrust at full deflection, in the pull that the hole has here by Newton's law.
const PULLS: float = 4.0

var _pilot := PilotedObserver.new()
var _thrust := Vector3.ZERO


## From `place` on with a `celerity` relative to rain.
static func from(place: Vector3, celerity: Vector3) -> PilotedRide:
	var ride := new()
	if ride._pilot.start(place, celerity) != OK:
		ride.refusal = _translated(
			"No flight can start here: the motion is too near to that of light."
		)
	return ride


## The largest thrust at a radius.
static func full_thrust(radius: float) -> float:
	return PULLS * 0.5 / (radius * radius)


func get_title() -> String:
	return _translated("Piloted flight")


func get_place() -> Vector3:
	return _pilot.get_position()


func get_celerity() -> Vector3:
	return _pilot.get_celerity()


func get_proper_time() -> float:
	return _pilot.get_proper_time()


func get_rain_time() -> float:
	return _pilot.get_rain_time()


## Seen straight away from the middle of the hole's shadow.
func get_far_clock_rate() -> float:
	var observer := SkyObserver.new()
	set_motion(observer)
	var shadow: Vector3 = observer.shadow(get_place())["direction"]
	return _pilot.far_clock_rate(-shadow)


func get_thrust() -> Vector3:
	return _thrust


func is_reversible() -> bool:
	return false


func steer(wish: Vector3, _seconds: float) -> void:
	_thrust = wish * full_thrust(_pilot.get_radius())


func advance(proper_time: float) -> bool:
	var ended := _pilot.advance(maxf(proper_time, 0.0), _thrust)
	return ended == PilotedObserver.PROGRESS_ON_THE_WAY and _pilot.get_radius() > NEAREST
