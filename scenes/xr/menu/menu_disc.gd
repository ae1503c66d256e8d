# SPDX-License-Identifier: MIT
class_name MenuDisc
extends PointTarget
## A small disc below the visitor's gaze that opens the menu: whoever has no controllers looks at it
## for a second. Child of the origin. It comes along when the visitor turns away, and fades while
## nobody looks down.

## It has been chosen.
signal pressed

@export var head: Node3D
## Opens when the disc is chosen; empty: `pressed` is all that happens.
@export var menu: XrMenu
## So far below the horizon it is seen.
@export_range(10.0, 80.0, 1.0, "suffix:°") var lower_degrees: float = 52.0
## The disc's diameter.
@export_range(1.0, 10.0, 0.1, "suffix:°") var disc_degrees: float = 3.5
## How far from the head, metres.
@export_range(0.3, 5.0, 0.1, "suffix:m") var distance: float = 1.2
## It comes along when the visitor has turned so far from it.
@export_range(10.0, 180.0, 1.0, "suffix:°") var lazy_degrees: float = 60.0
## Looking down by the first angle it begins to appear, by the second it is all there.
@export var appears_degrees := Vector2(24.0, 36.0)
## What is left of it while nobody looks down, 0 to 1.
@export_range(0.0, 1.0) var resting_opacity: float = 0.12
@export_range(0.3, 5.0, 0.1, "suffix:s") var dwell: float = 1.0
## Seconds in which it comes along.
@export_range(0.05, 2.0, 0.05, "suffix:s") var follow_seconds: float = 0.35

var picture := FlatPicture.new()

var _face := MenuDiscFace.new()
## The level direction from the head to it, as an angle, and where that is to be.
var _bearing: float = NAN
var _wanted: float = 0.0
var _is_pointed_at: bool = false


func _ready() -> void:
	picture.pixels = Vector2i(400, 350)
	picture.width = 2.0 * distance * tan(deg_to_rad(0.5 * disc_degrees)) / MenuDiscFace.DISC
	picture.viewport.add_child(_face)
	add_child(picture)


func _notification(what: int) -> void:
	if what == NOTIFICATION_TRANSLATION_CHANGED and is_node_ready():
		_face.queue_redraw()
		picture.redraw()


func _process(delta: float) -> void:
	var pose := _head_in_room()
	var back := XrRig.backwards(pose.basis)
	var bearing := atan2(back.x, back.z)
	if is_nan(_bearing):
		_bearing = bearing
		_wanted = bearing
	if absf(angle_difference(bearing, _wanted)) > deg_to_rad(lazy_degrees):
		_wanted = bearing
	_bearing = lerp_angle(_wanted, _bearing, exp(-delta / follow_seconds))
	_stand_below(pose.origin)
	picture.opacity = _opacity(rad_to_deg(asin(clampf(pose.basis.z.normalized().y, -1.0, 1.0))))
	visible = not _is_menu_in_view(back)


func distance_along(from: Vector3, direction: Vector3) -> float:
	return distance_to_flat(from, direction, picture.get_extent())


func point_at(_place: Vector3) -> void:
	_light(true)


func leave() -> void:
	_light(false)


func dwell_seconds() -> float:
	return dwell


func what_is_pointed_at() -> Variant:
	return self if _is_pointed_at else null


func choose() -> bool:
	pressed.emit()
	if menu != null:
		menu.open(head.global_transform)
	return true


## How much of it is seen, 0 to 1, by who looks down by so many degrees.
func _opacity(down: float) -> float:
	if _is_pointed_at:
		return 1.0
	return lerpf(resting_opacity, 1.0, smoothstep(appears_degrees.x, appears_degrees.y, down))


func _light(is_lit: bool) -> void:
	if is_lit != _is_pointed_at:
		_is_pointed_at = is_lit
		_face.lit = is_lit
		picture.redraw()


func _head_in_room() -> Transform3D:
	var room := get_parent_node_3d()
	if room == null:
		return head.global_transform
	return room.global_transform.affine_inverse() * head.global_transform


# Before and below the head, turned to it.
func _stand_below(eyes: Vector3) -> void:
	var level := Basis(Vector3.UP, _bearing)
	var turned := level * Basis(Vector3.RIGHT, -deg_to_rad(lower_degrees))
	transform = Transform3D(turned, eyes - turned.z * distance)


func _is_menu_in_view(back: Vector3) -> bool:
	if menu == null or not menu.is_open():
		return false
	return menu.transform.basis.z.dot(back) > cos(deg_to_rad(lazy_degrees))
