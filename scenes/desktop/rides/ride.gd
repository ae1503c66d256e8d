# SPDX-License-Identifier: MIT
class_name Ride
extends RefCounted
## A motion that takes the eye along, at a pace that the director sets.
##
## Places are from the hole in Schwarzschild radii, times in the light travel time of one (r_s/c),
## celerities (velocity times Lorentz factor) in units of c, accelerations in c^2/r_s.
##
## The rides' static constructors say new() without the class's name: Godot 4.6 does not always free
## scripts that name themselves there before it ends, and then complains of resources in use.

## Rides end here: nearer, the picture changes only by growing darker.
const NEAREST: float = 0.05

## Why the ride cannot be started; empty when all is well.
var refusal: String = ""


## What the ride is called.
func get_title() -> String:
	return ""


func get_place() -> Vector3:
	return Vector3.ZERO


## Relative to the rain frame.
func get_celerity() -> Vector3:
	return Vector3.ZERO


func get_proper_time() -> float:
	return 0.0


## The common clock of all who fall from rest at infinity, since the start.
func get_rain_time() -> float:
	return 0.0


## How fast far clocks are seen to tick, per tick of the own; NAN where none is seen.
func get_far_clock_rate() -> float:
	return NAN


## Proper acceleration.
func get_thrust() -> Vector3:
	return Vector3.ZERO


## Whether time can run backwards and be sought.
func is_reversible() -> bool:
	return true


## Whether the hole takes part.
func has_hole() -> bool:
	return true


## What the keys and sticks ask for, in world axes, length 0 to 1; `seconds` of the viewer's time.
func steer(_wish: Vector3, _seconds: float) -> void:
	pass


## Lets proper time pass, backwards when negative. False at an end of the ride.
func advance(_proper_time: float) -> bool:
	return false


## How far along the ride is, 0 to 1.
func get_progress() -> float:
	return 0.0


func seek(_progress: float) -> void:
	pass


## Lets the sky be seen with the ride's motion.
func set_motion(observer: SkyObserver) -> void:
	observer.motion = LensingTable.MOTION_VELOCITY
	observer.relative_to_static = false
	observer.celerity = get_celerity()


static func _translated(text: String) -> String:
	return TranslationServer.translate(text)
