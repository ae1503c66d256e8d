# SPDX-License-Identifier: MIT
class_name XrRides
extends Node
## Takes a visitor along: falls and orbits, started by the visitor, after a countdown, with a pause
## and a way out at any time.
##
## For a ride the hole becomes so large that one's own head is small beside it; afterwards the room
## is as it was. The horizon of rides is level: the hole is at the height of the eyes.

## So many seconds are left until the ride begins.
signal counted_down(seconds: int)
signal began
## It is over; `completed`: it came to its own end, nobody left it.
signal ended(completed: bool)
signal pause_changed(paused: bool)

enum Kind { FALL, ORBIT_RIGHT, ORBIT_LEFT }
enum State { NONE, COUNTDOWN, BEGINNING, RIDING, ENDING }

## So far out of their seats people lean, in Schwarzschild radii of a ride's hole.
const LEANING: float = 0.2

@export var rig: XrRig
@export var sky: BlackHoleSky
## Off during rides; may be none.
@export var near_limit: NearLimit
## Follows the ride's clock; may be none.
@export var disk: AccretionDisk
@export var curtain: Curtain
## The hole's radius during a ride, metres.
@export_range(5.0, 100.0, 1.0, "suffix:m") var metres: float = 30.0
## Falls begin here, almost at rest, in Schwarzschild radii.
@export_range(3.0, 30.0) var fall_from: float = 12.0
## Orbits are stable from 3 on; those who are nearer are taken here.
@export_range(3.0, 30.0) var least_orbit: float = 4.0
@export_range(0, 10) var countdown_seconds: int = 3
## The room turns with an orbit, so that the hole stays where it was for the visitor.
@export var keeps_hole_ahead: bool = true
## At the end of a fall the picture goes black from this radius on.
@export_range(0.06, 0.5) var dark_from: float = 0.15

var state: State = State.NONE
## The ride that is on, or null.
var ride: Ride
var pace := RidePace.new()

var _kind: Kind
var _counting: float = 0.0
var _seat: Vector3
var _azimuth: float = 0.0
var _disk_start: float = 0.0
var _observer := SkyObserver.new()
# What was before the ride.
var _room: Transform3D
var _radius: float = 0.0
var _observer_before: SkyObserver


func _process(delta: float) -> void:
	advance(minf(delta, 0.1))


func is_on() -> bool:
	return state != State.NONE


## Starts the countdown to a ride, if none is on.
func start(kind: Kind) -> void:
	if is_on():
		return
	_kind = kind
	_counting = countdown_seconds
	state = State.COUNTDOWN
	counted_down.emit(countdown_seconds)


## Ends the ride, or the countdown to it, and brings the visitor back to the room.
func leave() -> void:
	_end(false)


func set_paused(paused: bool) -> void:
	if is_on() and pace.paused != paused:
		pace.paused = paused
		pause_changed.emit(paused)


func toggle_pause() -> void:
	set_paused(not pace.paused)


func is_paused() -> bool:
	return is_on() and pace.paused


## The hole's radius in the room, metres, be a ride on or not.
func get_home_radius() -> float:
	return _radius if _is_away() else sky.schwarzschild_radius


## Where the room stands when no ride is on, or will stand after it.
func get_home() -> Transform3D:
	return _room if _is_away() else rig.get_room()


## Lets `seconds` pass.
func advance(seconds: float) -> void:
	match state:
		State.COUNTDOWN:
			_count(seconds)
		State.RIDING:
			_go(seconds)


func _is_away() -> bool:
	return state == State.RIDING or state == State.ENDING


func _count(seconds: float) -> void:
	if pace.paused:
		return
	var before := ceili(_counting)
	_counting -= seconds
	if _counting <= 0.0:
		state = State.BEGINNING
		rig.blink(_begin)
	elif ceili(_counting) != before:
		counted_down.emit(ceili(_counting))


func _begin() -> void:
	if state != State.BEGINNING:
		return
	_room = rig.get_room()
	_radius = sky.schwarzschild_radius
	_observer_before = sky.observer
	var outward := rig.get_place() * Vector3(1.0, 0.0, 1.0)
	outward = outward.normalized() if outward.length() > 1e-3 else Vector3.BACK
	ride = _make(outward, rig.get_radius())
	pace.reset()
	if near_limit != null:
		near_limit.enabled = false
	if disk != null:
		_disk_start = disk.time
	_seat = rig.get_seat()
	sky.schwarzschild_radius = metres
	_azimuth = XrRig.azimuth_of(ride.get_place())
	state = State.RIDING
	rig.jump_to(ride.get_place() * metres)
	_take_along()
	if keeps_hole_ahead:
		_turn_to_hole(outward)
	began.emit()


func _make(outward: Vector3, radius: float) -> Ride:
	if _kind == Kind.FALL:
		# Dropped from a little farther out: who leans back must not be where the fall never was.
		var fall := FallRide.from_rest(fall_from + LEANING, outward)
		fall.seek(fall.progress_of(fall_from))
		return fall
	var axis := Vector3.UP if _kind == Kind.ORBIT_RIGHT else Vector3.DOWN
	return OrbitRide.from(outward * maxf(radius, least_orbit), axis)


func _go(seconds: float) -> void:
	var passed := pace.passed(ride.get_place().length(), seconds)
	var goes_on := passed == 0.0 or ride.advance(passed)
	_take_along()
	if not goes_on:
		_end(true)


func _take_along() -> void:
	var place := ride.get_place()
	var azimuth := XrRig.azimuth_of(place)
	if keeps_hole_ahead and absf(angle_difference(_azimuth, azimuth)) > 1e-9:
		rig.turn(angle_difference(_azimuth, azimuth))
	_azimuth = azimuth
	rig.glide_seat_to(_seat, place * metres)
	ride.set_motion(_observer)
	sky.observer = _observer
	if disk != null:
		disk.time_scale = 0.0
		disk.time = _disk_start + ride.get_rain_time()
	if curtain != null:
		curtain.set_darkness(self, 1.0 - smoothstep(Ride.NEAREST, dark_from, place.length()))


# Aberration shows the hole elsewhere than it is: the room is turned so that it is seen where it
# was.
func _turn_to_hole(outward: Vector3) -> void:
	var seen: Vector3 = _observer.shadow(ride.get_place()).get("direction", -outward)
	rig.snap(angle_difference(XrRig.azimuth_of(seen), XrRig.azimuth_of(-outward)) * -1.0)
	rig.jump_to(ride.get_place() * metres)


func _end(completed: bool) -> void:
	match state:
		State.COUNTDOWN, State.BEGINNING:
			state = State.NONE
			pace.reset()
			ended.emit(false)
		State.RIDING:
			state = State.ENDING
			rig.blink(_return.bind(completed))


func _return(completed: bool) -> void:
	ride = null
	sky.schwarzschild_radius = _radius
	sky.observer = _observer_before
	rig.set_room(_room)
	if near_limit != null:
		near_limit.enabled = true
	if disk != null:
		disk.time_scale = 1.0
	if curtain != null:
		curtain.set_darkness(self, 0.0)
	pace.reset()
	state = State.NONE
	ended.emit(completed)
