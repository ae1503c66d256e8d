# SPDX-License-Identifier: MIT
class_name XrRig
extends Node
## Where the visitor is: moves the room so that the head comes to a place, turns it about the head,
## and says how strongly the visitor is being moved.
##
## All ways to move work through this node; what the visitor's own feet and neck do comes on top.

## The room has been moved at once, not glidingly.
signal jumped

## Seconds in which a blink closes, and opens again.
const BLINK_SECONDS: float = 0.12
## Between the two the picture stays black so long.
const BLINK_HOLD_SECONDS: float = 0.06
## Being moved so fast is as strong as it gets, radians a second of what is seen.
const STRONG: float = 0.7
## Motion counts so long after it has ended, seconds.
const SETTLING: float = 0.12

@export var origin: XROrigin3D
@export var head: Node3D
@export var sky: BlackHoleSky
## Closes for blinks; none: jumps are seen.
@export var curtain: Curtain
## None: everything as in the preset Comfort.
@export var comfort: Comfort

var _turned: float = 0.0
var _gone: float = 0.0
var _motion: float = 0.0
var _blink: Tween
var _darkness: float = 0.0


func _process(delta: float) -> void:
	var flow := (_turned + _gone / maxf(get_radius_metres(), 1e-3)) / maxf(delta, 1e-4)
	var strength := clampf(flow / STRONG, 0.0, 1.0)
	_motion = maxf(strength, _motion * exp(-delta / SETTLING))
	_turned = 0.0
	_gone = 0.0


## From the hole's centre to the head, in Schwarzschild radii.
func get_radius() -> float:
	return get_radius_metres() / sky.schwarzschild_radius


## The same in metres.
func get_radius_metres() -> float:
	return get_place().length()


## From the hole's centre to the head, metres.
func get_place() -> Vector3:
	return head.global_position - sky.global_position


## How strongly the visitor is being moved now: 0 not at all, 1 so that it can make sick.
func get_motion() -> float:
	return _motion


## Moves the room so that the head is at `place` (metres from the hole's centre); gliding.
func glide_to(place: Vector3) -> void:
	var step := place - get_place()
	_gone += step.length()
	origin.global_position += step


## Moves the room so that its point `seat` (metres, in the room) is at `place` (metres from the
## hole's centre); gliding. Heads move about their seats.
func glide_seat_to(seat: Vector3, place: Vector3) -> void:
	var step := sky.global_position + place - origin.global_transform * seat
	_gone += step.length()
	origin.global_position += step


## Turns the room about the head, `angle` radians to the left; gliding.
func turn(angle: float) -> void:
	_turned += absf(angle)
	_turn_about_head(angle)


## The same at once.
func snap(angle: float) -> void:
	_turn_about_head(angle)
	jumped.emit()


## Moves the room at once so that the head is at `place` (metres from the hole's centre).
func jump_to(place: Vector3) -> void:
	origin.global_position += place - get_place()
	jumped.emit()


## Raises the visitor by so many metres, at once.
func lift(metres: float) -> void:
	origin.global_position.y += metres
	jumped.emit()


## Where the head is in the room, metres.
func get_seat() -> Vector3:
	return origin.global_transform.affine_inverse() * head.global_position


## The room as it stands in the world.
func get_room() -> Transform3D:
	return origin.global_transform


## Puts the room there at once.
func set_room(room: Transform3D) -> void:
	origin.global_transform = room
	jumped.emit()


## Yaw of what is ahead of the head, radians to the left of -z.
func get_yaw() -> float:
	return azimuth_of(-backwards(head.global_basis))


## Radians to the left of -z, seen from above.
static func azimuth_of(direction: Vector3) -> float:
	return atan2(-direction.x, -direction.z)


## The level direction behind a head, length 1.
static func backwards(looking: Basis) -> Vector3:
	var back := looking.z
	if Vector2(back.x, back.z).length() < 0.2:
		# Who looks straight down has the top of the head ahead; straight up, behind.
		back = -looking.y * signf(looking.z.y)
	back.y = 0.0
	return back.normalized() if back.length() > 1e-3 else Vector3.BACK


## Where something stands upright before a head, turned to it by its bearing alone: `metres` away
## and so much lower than straight ahead.
static func before(head_pose: Transform3D, metres: float, lower_degrees: float) -> Transform3D:
	var back := backwards(head_pose.basis)
	var drop := Vector3.DOWN * metres * tan(deg_to_rad(lower_degrees))
	var upright := Basis(Vector3.UP.cross(back), Vector3.UP, back)
	return Transform3D(upright, head_pose.origin - back * metres + drop)


## Does `change` while the picture is black for a moment; at once where blinks are off. A change
## that is asked for during a blink comes after it.
func blink(change: Callable) -> void:
	if curtain == null or not _blinks() or not is_inside_tree():
		change.call()
		return
	if _blink != null and _blink.is_running():
		await _blink.finished
	_blink = create_tween()
	_blink.tween_method(_set_darkness, _darkness, 1.0, BLINK_SECONDS)
	_blink.tween_callback(change)
	_blink.tween_interval(BLINK_HOLD_SECONDS)
	_blink.tween_method(_set_darkness, 1.0, 0.0, BLINK_SECONDS)


func is_blinking() -> bool:
	return _blink != null and _blink.is_running()


func _blinks() -> bool:
	return comfort == null or comfort.blinks


func _set_darkness(darkness: float) -> void:
	_darkness = darkness
	curtain.set_darkness(self, darkness)


func _turn_about_head(angle: float) -> void:
	var pivot := head.global_position
	var turn_basis := Basis(Vector3.UP, angle)
	var room := origin.global_transform
	origin.global_transform = Transform3D(
		turn_basis * room.basis, pivot + turn_basis * (room.origin - pivot)
	)
