# SPDX-License-Identifier: MIT
class_name TourView
extends RefCounted
## Where an eye is and how it looks: what lies between two views is one too.
##
## The frame has the hole straight ahead (-z); its place follows from it and the distance, so that
## the hole stays where it is in the picture while the eye goes round it.

## Turns the axes of a look at the hole into the sky's.
var frame := Quaternion.IDENTITY
## Natural logarithm of the distance in Schwarzschild radii.
var log_radius: float = 0.0
## From the look at the hole to where the eye looks, in the frame's axes.
var turn := Quaternion.IDENTITY
## Natural logarithm of the picture's height in degrees.
var log_field: float = 0.0


## What is seen at one of a station's captions.
static func of_station(station: TourStation, caption: int = 0) -> TourView:
	var view := new()
	var behind := station.get_direction_behind()
	var north := Vector3.UP if absf(behind.y) < 0.999 else Vector3.BACK
	var up := north.rotated(behind, -deg_to_rad(station.roll))
	view.frame = Basis.looking_at(behind, up).get_rotation_quaternion()
	view.set_radius(station.get_radius_at(caption))
	view.set_field(station.get_field_at(caption))
	view.turn = _turn_of(station.get_look_at(caption), station.look_offset)
	return view


## What a rig sees through a picture of so many degrees.
static func of_rig(rig: ViewRig, field: float) -> TourView:
	var view := new()
	var straight := ViewRig.new()
	straight.look_from(rig.get_position(), rig.get_orientation() * Vector3.UP)
	view.frame = straight.get_orientation()
	view.turn = (view.frame.inverse() * rig.get_orientation()).normalized()
	view.set_radius(rig.get_distance())
	view.set_field(field)
	return view


## The one at `share` (0 to 1) of the way from one view to another.
static func between(from: TourView, to: TourView, share: float) -> TourView:
	var view := new()
	view.frame = from.frame.slerp(to.frame, share)
	view.turn = from.turn.slerp(to.turn, share)
	view.log_radius = lerpf(from.log_radius, to.log_radius, share)
	view.log_field = lerpf(from.log_field, to.log_field, share)
	return view


## A copy.
func copy() -> TourView:
	return between(self, self, 0.0)


## Whether nobody would see a difference.
func is_like(other: TourView) -> bool:
	return (
		absf(log_radius - other.log_radius) < 1e-3
		and absf(log_field - other.log_field) < 1e-3
		and frame.angle_to(other.frame) < 1e-3
		and turn.angle_to(other.turn) < 1e-3
	)


func get_radius() -> float:
	return exp(log_radius)


func set_radius(radius: float) -> void:
	log_radius = log(radius)


func get_field() -> float:
	return exp(log_field)


func set_field(degrees: float) -> void:
	log_field = log(degrees)


func get_place() -> Vector3:
	return frame * Vector3.BACK * get_radius()


func get_orientation() -> Quaternion:
	return (frame * turn).normalized()


static func _turn_of(look: TourStation.Look, offset: Vector2) -> Quaternion:
	var turned := 0.0
	match look:
		TourStation.Look.AWAY:
			turned = PI
		TourStation.Look.ALONG:
			turned = -0.5 * PI
	var aside := Quaternion(Vector3.UP, turned - deg_to_rad(offset.x))
	return aside * Quaternion(Vector3.RIGHT, deg_to_rad(offset.y))
