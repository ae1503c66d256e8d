# SPDX-License-Identifier: MIT
class_name StartView
extends RefCounted
## The first view: the hole in front of the centre of the Milky Way.
##
## World axes: x to right ascension 0h, y to the celestial north pole, z to -(6h).

## Distance of the eye, in Schwarzschild radii.
const DISTANCE: float = 12.0
## Galactic centre and north pole (ICRS): right ascension and declination in degrees.
const GALACTIC_CENTRE := Vector2(266.405, -28.936)
const GALACTIC_POLE := Vector2(192.859, 27.128)
## How far the centre is moved out of the middle, in degrees: along the band and across it. On the
## axis it would be one even ring; beside it, its two images and the arcs can be told apart.
const OFFSET := Vector2(5.0, 2.0)
## Slant of the Milky Way in the picture, in degrees.
const SLANT: float = -24.0


## Unit vector of a place on the sky, from right ascension (x) and declination (y) in degrees.
static func sky_direction(degrees: Vector2) -> Vector3:
	var ra := deg_to_rad(degrees.x)
	var declination := deg_to_rad(degrees.y)
	return Vector3(cos(declination) * cos(ra), sin(declination), -cos(declination) * sin(ra))


## Puts the eye where the programme starts.
static func apply_to(rig: ViewRig) -> void:
	var centre := sky_direction(GALACTIC_CENTRE)
	var pole := sky_direction(GALACTIC_POLE)
	var along := centre.cross(pole).normalized()
	var behind := centre.rotated(pole, deg_to_rad(OFFSET.x)).rotated(along, deg_to_rad(OFFSET.y))
	rig.look_from(-behind * DISTANCE, pole.rotated(behind, deg_to_rad(SLANT)))
