# SPDX-License-Identifier: MIT
class_name NearLimit
extends Node
## What happens when a head comes to the hole by walking: the picture fades to black before the sky
## would rush together, and comes back as soon as the visitor steps back.
##
## Nobody rests at the horizon: the observers that could be there fall, and a fall that one's feet
## do not feel makes sick. Falls are rides, which the visitor starts.

## The head has come too near, or is no longer so.
signal crossed(too_near: bool)

## Here the picture begins to fade, and here it is black; in radii of the hole.
@export var fade_from: float = 2.0
@export var black_from: float = 1.4
@export var sky: BlackHoleSky
@export var head: Node3D
@export var curtain: Curtain
## Off while a ride moves the visitor.
@export var enabled: bool = true

var _too_near: bool = false


func _process(_delta: float) -> void:
	var r := head.global_position.distance_to(sky.global_position) / sky.schwarzschild_radius
	var dark := darkness(r) if enabled else 0.0
	curtain.set_darkness(self, dark)
	var too_near := dark > 0.0
	if too_near != _too_near:
		_too_near = too_near
		crossed.emit(_too_near)


## How much of the picture is taken away at r radii: 0 none, 1 all.
func darkness(r: float) -> float:
	return 1.0 - smoothstep(black_from, fade_from, r)
