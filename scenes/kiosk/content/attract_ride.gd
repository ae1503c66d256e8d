# SPDX-License-Identifier: MIT
class_name AttractRide
extends Camera3D
## The slow way round the hole that calls visitors: it comes near, so that the ring grows, goes away
## again, and never ends.

## One turn round the hole, and one way to and fro, seconds: no common measure, no repetition.
const TURN_SECONDS: float = 240.0
const BREATH_SECONDS: float = 67.0
## Nearest and farthest, in Schwarzschild radii.
const NEAREST: float = 7.0
const FARTHEST: float = 18.0
## How far above and below the plane of the first view, radians.
const TILT: float = 0.35
## The picture's middle lies so much beside the hole, for the words: parts of the distance.
const ASIDE: float = 0.32

## Not what only the visitor sees, and not the sign in the headset.
const SEEN: int = 0xFFFFF & ~2 & ~KioskBoard.LAYER

var sky: BlackHoleSky

var _rig := ViewRig.new()
var _seconds: float = 0.0


func _ready() -> void:
	cull_mask = SEEN
	near = 0.01
	far = 4000.0
	fov = 62.0
	set_process(false)


func _process(delta: float) -> void:
	advance(delta)


## Begins, and takes the picture; or ends.
func run(on: bool) -> void:
	set_process(on and sky != null)
	current = on
	if on and sky != null:
		advance(0.0)


## Goes on.
func advance(seconds: float) -> void:
	_seconds = fmod(_seconds + seconds, TURN_SECONDS * BREATH_SECONDS)
	place_at(_seconds)
	global_transform = Transform3D(
		Basis(_rig.get_orientation()),
		sky.global_position + _rig.get_position() * sky.schwarzschild_radius
	)


## Where the ride is after so long, for the rig.
func place_at(seconds: float) -> void:
	StartView.apply_to(_rig)
	_rig.orbit(TAU * seconds / TURN_SECONDS, TILT * sin(TAU * seconds / BREATH_SECONDS))
	var share := 0.5 + 0.5 * cos(TAU * seconds / BREATH_SECONDS)
	var distance := NEAREST * pow(FARTHEST / NEAREST, share)
	_rig.approach(log(_rig.get_distance() / distance))
	_rig.turn(-atan(ASIDE), 0.0, 0.0)


func get_distance() -> float:
	return _rig.get_distance()
