# SPDX-License-Identifier: MIT
class_name HoleInRoom
extends Node
## Puts the hole into the visitor's room, so large that one can walk round it and so near that it is
## worth it.

## The hole has a new size or place.
signal placed(radius: float)

## Schwarzschild radii that a hole in a room may have, metres.
const LEAST_RADIUS: float = 0.3
const LARGEST_RADIUS: float = 3.0
## So far from the hole's centre one walks or stands at first, in its radii.
const WALK_RADII: float = 5.0
## Nobody walks nearer to the edge of the play area than this, metres.
const MARGIN: float = 0.35
## So steeply, radians, one looks down on the hole's centre at first: what lies level round the hole
## is then seen from above.
const DIP: float = PI / 12.0

@export var sky: BlackHoleSky
@export var origin: XROrigin3D


## Fits the hole to the play area (corners on the floor; none: one stands) and the eyes' place in
## the room, `head`. Without room to walk it stands in front of the visitor.
func place(play_area: PackedVector3Array, head: Transform3D) -> void:
	var free := free_radius(play_area)
	var ahead := Vector3(-head.basis.z.x, 0.0, -head.basis.z.z)
	ahead = ahead.normalized() if ahead.length() > 1e-3 else Vector3.FORWARD
	var radius := fitting_radius(free)
	var eyes := head.origin
	var centre := eyes + ahead * radius * WALK_RADII * cos(DIP)
	if free >= 0.99 * radius * WALK_RADII:
		# Room to walk all round: in its middle, unless the visitor stands there.
		var middle := _middle_of(play_area)
		var away := Vector2(eyes.x - middle.x, eyes.z - middle.z).length()
		if away > 0.6 * radius * WALK_RADII:
			centre = middle
	centre.y = eyes.y - radius * WALK_RADII * sin(DIP)
	sky.schwarzschild_radius = radius
	sky.global_position = origin.global_transform * centre
	placed.emit(radius)


## The largest circle round the middle of a play area in which one may walk, metres; 0: none.
static func free_radius(play_area: PackedVector3Array) -> float:
	if play_area.size() < 3:
		return 0.0
	var middle := _middle_of(play_area)
	var least := INF
	for i in play_area.size():
		var from := play_area[i]
		var to := play_area[(i + 1) % play_area.size()]
		var nearest := Geometry3D.get_closest_point_to_segment(middle, from, to)
		least = minf(least, Vector2(nearest.x - middle.x, nearest.z - middle.z).length())
	return maxf(least - MARGIN, 0.0)


## Radius of the hole round which one walks on a circle of this radius (metres).
static func fitting_radius(walk_radius: float) -> float:
	return clampf(walk_radius / WALK_RADII, LEAST_RADIUS, LARGEST_RADIUS)


static func _middle_of(corners: PackedVector3Array) -> Vector3:
	var sum := Vector3.ZERO
	for corner in corners:
		sum += corner
	return Vector3(sum.x, 0.0, sum.z) / maxf(corners.size(), 1.0)
