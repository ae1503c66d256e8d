# SPDX-License-Identifier: MIT
class_name Flight
extends Node
## Flies where a hand points, as long as its stick is pushed forwards or back. Closing the hand is
## the throttle. Near the hole everything goes slower, in proportion to the distance.
##
## The limits keep the visitor where the sky can be looked at by somebody at rest.

@export var rig: XrRig
@export var hands: Array[XrHand] = []
## At full throttle the distance changes by this factor e in so many seconds.
@export_range(0.5, 20.0, 0.1, "suffix:s") var seconds_per_e: float = 2.5
## Share of that speed with an open hand.
@export_range(0.1, 1.0) var open_hand: float = 0.4
## Nearest and farthest place, in Schwarzschild radii.
@export_range(1.0, 10.0) var nearest: float = 2.2
@export_range(5.0, 100.0) var farthest: float = 40.0
@export var enabled: bool = false

var _rate := EasedRate.new(0.15)


func _process(delta: float) -> void:
	advance(minf(delta, 0.1))


## Lets `seconds` pass.
func advance(seconds: float) -> void:
	if not enabled:
		_rate.stop()
		return
	var way := _rate.advance(_asked(), seconds)
	if way.length() < 1e-7:
		return
	var place := rig.get_place()
	var next := place + way * place.length()
	var radius := rig.sky.schwarzschild_radius
	var length := next.length()
	# Whoever is beyond a limit, by walking or by another way to move, may come back.
	var least := minf(nearest * radius, place.length())
	var most := maxf(farthest * radius, place.length())
	if length < least or length > most:
		next = next * (clampf(length, least, most) / length)
	rig.glide_to(next)


## Speed in distances from the hole a second: the open hand's share at least, all with it closed.
func speed(stick: float, grip: float) -> float:
	return stick * lerpf(open_hand, 1.0, grip) / seconds_per_e


func _asked() -> Vector3:
	var hand := Sticks.strongest_hand(hands, rig.comfort, Sticks.Axis.Y)
	if hand == null:
		return Vector3.ZERO
	var stick := hand.get_steer()
	# A stick that is pushed to a side turns.
	if absf(stick.x) > absf(stick.y):
		return Vector3.ZERO
	return hand.get_direction() * speed(stick.y, hand.get_grip())
