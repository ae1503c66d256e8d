# SPDX-License-Identifier: MIT
class_name ViewControls
extends Node
## Moves the camera by keyboard, mouse and gamepad: round the hole, in free flight, or looking round
## on a ride, which itself moves the eye.

signal mode_changed(mode: Mode)

enum Mode { ORBIT, FLIGHT, RIDE }
## Where the eye keeps looking on a ride.
enum Gaze { FREE, HOLE, AWAY }

## Radians per second at full deflection: going round the hole, turning the head, rolling it.
const ORBIT_SPEED: float = 0.9
const TURN_SPEED: float = 0.9
const ROLL_SPEED: float = 0.8
## Change of the distance's natural logarithm per second at full deflection.
const APPROACH_SPEED: float = 0.8
const FLIGHT_SPEED: float = 0.6
const FAST: float = 3.0
## Natural logarithm of the change in distance by one notch of the wheel.
const WHEEL_STEP: float = 0.12
## Angle round the hole when the mouse is drawn over the whole height of the window.
const DRAG_ORBIT: float = PI
## Seconds in which motion settles.
const RATE_SETTLING: float = 0.16
const MOUSE_SETTLING: float = 0.06
const FACING_SETTLING: float = 0.35
const AT_ONCE: float = 1e-4
## Longest step; a hitch of the machine must not throw the eye away.
const LONGEST_STEP: float = 0.25

@export var camera: Camera3D
@export var sky: BlackHoleSky
## How far the mouse turns the view, and how fast keys and sticks do and fly.
@export_range(0.1, 4.0, 0.05) var mouse_sensitivity: float = 1.0
@export_range(0.1, 4.0, 0.05) var steering_sensitivity: float = 1.0
## Up turns the view down, and down up.
@export var inverted: bool = false
## A press of the key for flying faster holds until the next one.
@export var fast_toggles: bool = false:
	set(value):
		fast_toggles = value
		_fast = false
## Motion begins and ends gently; else at once.
@export var eased: bool = true:
	set(value):
		eased = value
		_set_settling()

var rig := ViewRig.new()
var mode: Mode = Mode.ORBIT:
	set(value):
		if mode != value:
			mode = value
			mode_changed.emit(mode)
## Where the eye looks on a ride, and the direction in which the middle of the hole is then seen.
var gaze: Gaze = Gaze.FREE
var hole_direction := Vector3.FORWARD
## While false keys and sticks do not steer; the mouse does.
var keys_listening: bool = true
## While false nothing steers the eye, and it comes to rest.
var listening: bool = true:
	set(value):
		listening = value
		if not listening:
			_dragging = false

var _orbiting := EasedRate.new(RATE_SETTLING)
var _turning := EasedRate.new(RATE_SETTLING)
var _flying := EasedRate.new(RATE_SETTLING)
var _drag_orbit := EasedRemainder.new(MOUSE_SETTLING)
var _drag_turn := EasedRemainder.new(MOUSE_SETTLING)
var _drag_axis := EasedRemainder.new(MOUSE_SETTLING)
var _dragging: bool = false
var _fast: bool = false


func _ready() -> void:
	reset()


func _process(delta: float) -> void:
	advance(minf(delta, LONGEST_STEP))


func _unhandled_input(event: InputEvent) -> void:
	if not listening:
		return
	if fast_toggles and event.is_action_pressed(&"fly_fast"):
		_fast = not _fast
	if event is InputEventMouseMotion:
		_drag((event as InputEventMouseMotion).relative)
	elif event is InputEventMouseButton:
		_press(event as InputEventMouseButton)
	elif event is InputEventMagnifyGesture:
		_drag_orbit.add(Vector3(0.0, 0.0, log((event as InputEventMagnifyGesture).factor)))


## Back to the first view, at rest, going round the hole.
func reset() -> void:
	StartView.apply_to(rig)
	for rate: EasedRate in [_orbiting, _turning, _flying]:
		rate.stop()
	for remainder: EasedRemainder in [_drag_orbit, _drag_turn, _drag_axis]:
		remainder.stop()
	mode = Mode.ORBIT
	_show()


## Between going round and flying; on a ride between looking freely, at the hole and away from it.
func toggle_mode() -> void:
	match mode:
		Mode.ORBIT:
			mode = Mode.FLIGHT
		Mode.FLIGHT:
			mode = Mode.ORBIT
		Mode.RIDE:
			gaze = ((gaze + 1) % Gaze.size()) as Gaze


## Lets `seconds` pass.
func advance(seconds: float) -> void:
	var orbit_rate := Vector3.ZERO
	var turn_rate := Vector3.ZERO
	var flight_rate := Vector3.ZERO
	if listening and keys_listening:
		var fast := _fast if fast_toggles else Input.is_action_pressed(&"fly_fast")
		var speed := steering_sensitivity * (FAST if fast else 1.0)
		turn_rate.z = Input.get_axis(&"roll_left", &"roll_right") * ROLL_SPEED
		if mode == Mode.ORBIT:
			orbit_rate = _asked_orbit() * speed
		else:
			var look := Input.get_vector(&"look_left", &"look_right", &"look_down", &"look_up")
			turn_rate.x = look.x * TURN_SPEED * steering_sensitivity
			turn_rate.y = _upwards(look.y) * TURN_SPEED * steering_sensitivity
			if mode == Mode.FLIGHT:
				flight_rate = asked_flight() * (FLIGHT_SPEED * speed)
	var round_hole := _orbiting.advance(orbit_rate, seconds) + _drag_orbit.advance(seconds)
	var head := _turning.advance(turn_rate, seconds) + _drag_turn.advance(seconds)
	var flown := _flying.advance(flight_rate, seconds)
	var revolved := _drag_axis.advance(seconds)
	if mode == Mode.RIDE:
		rig.turn(head.x, head.y, head.z)
	else:
		rig.orbit(round_hole.x, round_hole.y)
		rig.revolve(revolved)
		rig.approach(round_hole.z)
		rig.turn(head.x, head.y, head.z)
		rig.fly(flown)
	_face(1.0 - exp(-seconds / FACING_SETTLING) if eased else 1.0)
	_show()


## Goes round the hole about an axis through it, whose length is the angle; not on a ride, which has
## its own way.
func revolve(axis: Vector3) -> void:
	if listening:
		_drag_axis.add(axis)


## Where the keys and the stick ask to fly, in the eye's axes; length 0 to 1.
func asked_flight() -> Vector3:
	if not (listening and keys_listening):
		return Vector3.ZERO
	var level := Input.get_vector(&"fly_left", &"fly_right", &"fly_forward", &"fly_back")
	return Vector3(level.x, Input.get_axis(&"fly_down", &"fly_up"), level.y).limit_length()


func _upwards(asked: float) -> float:
	return -asked if inverted else asked


func _set_settling() -> void:
	for rate: EasedRate in [_orbiting, _turning, _flying]:
		rate.settling_time = RATE_SETTLING if eased else AT_ONCE
	for remainder: EasedRemainder in [_drag_orbit, _drag_turn, _drag_axis]:
		remainder.settling_time = MOUSE_SETTLING if eased else AT_ONCE


func _face(fraction: float) -> void:
	if mode == Mode.ORBIT:
		rig.face_hole(fraction)
	elif mode == Mode.RIDE and gaze != Gaze.FREE:
		rig.face(hole_direction if gaze == Gaze.HOLE else -hole_direction, fraction)


func _asked_orbit() -> Vector3:
	var stick := Input.get_vector(&"orbit_left", &"orbit_right", &"orbit_down", &"orbit_up")
	var sideways := Input.get_axis(&"fly_left", &"fly_right")
	var nearer := (
		Input.get_axis(&"recede", &"approach") + Input.get_axis(&"fly_back", &"fly_forward")
	)
	var both := (stick + Vector2(sideways, 0.0)).limit_length() * ORBIT_SPEED
	both.y = _upwards(both.y)
	return Vector3(both.x, both.y, clampf(nearer, -1.0, 1.0) * APPROACH_SPEED)


func _drag(relative: Vector2) -> void:
	if not _dragging:
		return
	var share := relative / maxf(get_viewport().get_visible_rect().size.y, 1.0)
	share = Vector2(share.x, _upwards(share.y)) * mouse_sensitivity
	if mode == Mode.ORBIT:
		_drag_orbit.add(Vector3(-share.x, share.y, 0.0) * DRAG_ORBIT)
	else:
		# The sky stays under the pointer.
		_drag_turn.add(Vector3(-share.x, share.y, 0.0) * deg_to_rad(camera.fov))


func _press(event: InputEventMouseButton) -> void:
	match event.button_index:
		MOUSE_BUTTON_LEFT, MOUSE_BUTTON_RIGHT:
			_dragging = event.pressed
		MOUSE_BUTTON_WHEEL_UP, MOUSE_BUTTON_WHEEL_DOWN:
			if not event.pressed:
				return
			var notches := event.factor if event.factor > 0.0 else 1.0
			var nearer := event.button_index == MOUSE_BUTTON_WHEEL_UP
			var way := WHEEL_STEP * notches * (1.0 if nearer else -1.0)
			_drag_orbit.add(Vector3(0.0, 0.0, way))


func _show() -> void:
	camera.transform = rig.get_transform(sky.schwarzschild_radius)
