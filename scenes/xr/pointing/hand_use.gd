# SPDX-License-Identifier: MIT
class_name HandUse
extends RefCounted
## Notices whether a hand is being used: it chooses, comes, or moves faster than one that rests or
## trembles.

## Faster than this it is being used: metres and radians a second, in the visitor's room.
const MOVES: float = 0.08
const TURNS: float = 0.2
## What it is compared with follows it in this time, seconds.
const _LAG: float = 0.4

var hand: XrHand
## Seconds since it was used last; INF: never, or it is not here.
var unused: float = INF

var _place := Vector3.ZERO
var _direction := Vector3.FORWARD
var _was_here: bool = false


func _init(of: XrHand) -> void:
	hand = of


## The hand has just been used.
func touch() -> void:
	unused = 0.0


## Takes in where the hand is after `delta` seconds.
func watch(delta: float) -> void:
	var here := hand.is_here()
	if not here:
		unused = INF
	elif not _was_here:
		_start_again()
	else:
		unused += delta
		var share := 1.0 - exp(-delta / _LAG)
		_place = _place.lerp(hand.position, share)
		_direction = _direction.lerp(-hand.basis.z, share)
		var moves := _place.distance_to(hand.position) > MOVES * _LAG
		if moves or _direction.angle_to(-hand.basis.z) > TURNS * _LAG or hand.is_choosing():
			_start_again()
	_was_here = here


func _start_again() -> void:
	_place = hand.position
	_direction = -hand.basis.z
	touch()
