# SPDX-License-Identifier: MIT
@tool
class_name TourStation
extends Resource
## A place of a tour: where the eye is and looks, how it moves, what the sky shows, what is said.
##
## The hole stands between the eye and the point of the sky that is chosen to be behind it.

enum Look {
	## At the hole.
	HOLE,
	## Away from it.
	AWAY,
	## Past it, square to the direction of the hole, which is then on the left.
	ALONG,
}
enum Motion {
	## The eye hovers.
	HOVER,
	## It is dropped at rest at `radius`.
	FALL_FROM_REST,
	## It falls from rest at infinity and passes `radius` when the station begins.
	FALL_FROM_INFINITY,
	## It is on a circular orbit of `radius`.
	ORBIT,
}
enum Disk { NONE, MUSEUM, PHYSICIST, FILM }
enum Ground { STARS_ALONE, GRID, MILKY_WAY }
enum Arrival {
	## By a smooth way, if there is one.
	GLIDE,
	## The picture goes dark for a moment.
	FADE,
}

## A short name without spaces, for logs.
@export var id: StringName = &""
## In English; it is the key of the translations.
@export var title: String = ""
@export var captions: Array[TourCaption] = []

@export_group("Place")
## Distance from the hole in Schwarzschild radii.
@export_range(0.1, 1000.0, 0.01, "suffix:rₛ") var radius: float = 12.0
## What is behind the hole: right ascension and declination (J2000) in degrees. The centre of the
## Milky Way is at (266.4, -28.9).
@export var behind := Vector2(266.405, -28.936)
## How far the north of the sky leans to the right in the picture; at 0 it is up.
@export_range(-180.0, 180.0, 1.0, "suffix:°") var roll: float = 0.0
@export var arrival: Arrival = Arrival.GLIDE
## How long the way there takes.
@export_range(0.0, 30.0, 0.5, "suffix:s") var travel_seconds: float = 4.0

@export_group("View")
@export var look: Look = Look.HOLE
## Turned aside from there: to the right and upwards, in degrees.
@export var look_offset := Vector2.ZERO
## Height of the picture on a screen.
@export_range(1.0, 120.0, 0.5, "suffix:°") var field_of_view: float = 70.0

@export_group("Motion")
@export var motion: Motion = Motion.HOVER
## Each step doubles the pace, or halves it.
@export_range(-6, 4) var pace: int = 0
## A fall stops here.
@export_range(0.06, 1000.0, 0.01, "suffix:rₛ") var waits_at: float = 0.2

@export_group("Sky")
@export var ground: Ground = Ground.MILKY_WAY
## How many images of each star are drawn.
@export_range(1, 4) var image_orders: int = 2
@export_range(-10.0, 10.0, 0.1, "suffix:EV") var exposure: float = 1.5
## The exposure follows the light, as the eye does; `exposure` is then added. Not in a headset.
@export var adapts: bool = false
## So much brighter in a headset, where the exposure does not follow the light.
@export_range(-10.0, 10.0, 0.1, "suffix:EV") var headset_brighter: float = 0.0
## Names of bright stars; not in a headset.
@export var star_names: bool = false
@export_custom(PROPERTY_HINT_FLAGS, TourCaption.LINES) var lines: int = 0

@export_group("Disk")
@export var disk: Disk = Disk.NONE
## Between its normal and the line of sight from the first view; 90 is edge on.
@export_range(0.0, 90.0, 1.0, "suffix:°") var disk_inclination: float = 84.0


## Where the eye is, in Schwarzschild radii from the hole and along the sky's axes.
func get_place() -> Vector3:
	return -get_direction_behind() * radius


## Unit vector to what is behind the hole.
func get_direction_behind() -> Vector3:
	return StartView.sky_direction(behind)


## The distance at one of its captions: that of the last one up to it which changes it.
func get_radius_at(caption: int) -> float:
	for i in range(caption, -1, -1):
		if captions[i].radius > 0.0:
			return captions[i].radius
	return radius


## The height of the picture at one of its captions, in degrees.
func get_field_at(caption: int) -> float:
	for i in range(caption, -1, -1):
		if captions[i].field_of_view > 0.0:
			return captions[i].field_of_view
	return field_of_view


## Where the eye looks at one of its captions.
func get_look_at(caption: int) -> Look:
	for i in range(caption, -1, -1):
		match captions[i].look:
			TourCaption.Look.HOLE:
				return Look.HOLE
			TourCaption.Look.AWAY:
				return Look.AWAY
			TourCaption.Look.ALONG:
				return Look.ALONG
	return look


## How many images of each star are drawn at one of its captions.
func get_orders_at(caption: int) -> int:
	for i in range(caption, -1, -1):
		if captions[i].image_orders > 0:
			return captions[i].image_orders
	return image_orders


## What is wrong with it; empty: nothing.
func find_problem() -> String:
	if title.is_empty():
		return "it has no title"
	if captions.is_empty():
		return "it has no captions"
	for caption in captions:
		if caption == null or caption.text.is_empty():
			return "a caption is empty"
	return _find_problem_of_place()


func _find_problem_of_place() -> String:
	var nearest := radius
	for caption in captions:
		if caption.radius > 0.0:
			nearest = minf(nearest, caption.radius)
	if motion == Motion.HOVER and nearest <= 1.0:
		return "nothing can hover at a radius of 1 or less: choose a ride"
	if motion == Motion.FALL_FROM_REST and radius <= 1.0:
		return "a fall from rest begins outside a radius of 1"
	if motion == Motion.ORBIT and radius <= 1.5:
		return "there is no orbit at a radius of 1.5 or less"
	return ""
