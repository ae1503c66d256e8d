# SPDX-License-Identifier: MIT
class_name RideDirector
extends Node
## Starts rides, lets their time pass, and takes the eye and the sky's observer along.

signal started
signal left
signal warned(topic: StringName, text: String)

enum Kind { FROM_REST, AS_RAIN, DROPPED, ORBIT_RIGHT, ORBIT_LEFT, PILOTED, VELOCITY }

const TOPIC: StringName = &"ride"
## Where long falls start, in Schwarzschild radii.
const HIGH: float = 30.0
## Scrubbing with a held key is so much faster than the usual pace.
const SCRUB: float = 6.0

@export var sky: BlackHoleSky
@export var controls: ViewControls
@export var switches: SkySwitches
@export var choice: ObserverChoice

## The ride that is on, or null.
var ride: Ride
var pace := RidePace.new()

var _observer: SkyObserver
var _mode_before := ViewControls.Mode.ORBIT


func _process(delta: float) -> void:
	advance(minf(delta, ViewControls.LONGEST_STEP))


## What a ride of a kind is called, for the panel.
static func title(kind: Kind) -> String:
	match kind:
		Kind.FROM_REST:
			return _translated("Fall from rest at 30 rₛ")
		Kind.AS_RAIN:
			return _translated("Fall from infinity, from 30 rₛ on")
		Kind.DROPPED:
			return _translated("Fall from rest here")
		Kind.ORBIT_RIGHT:
			return _translated("Circular orbit here, to the right")
		Kind.ORBIT_LEFT:
			return _translated("Circular orbit here, to the left")
		Kind.PILOTED:
			return _translated("Piloted flight from here")
	return _translated("Flight without the hole (special relativity)")


func is_on() -> bool:
	return ride != null


## Starts a ride; false, with a notice, where there is none.
func start(kind: Kind) -> bool:
	var next := _make(kind)
	if not next.refusal.is_empty():
		warned.emit(TOPIC, next.refusal)
		return false
	if not is_on():
		_mode_before = controls.mode
	ride = next
	pace.reset()
	choice.resting = true
	_observer = SkyObserver.new()
	switches.want_hole(ride.has_hole())
	var orbits := kind == Kind.ORBIT_RIGHT or kind == Kind.ORBIT_LEFT
	controls.gaze = ViewControls.Gaze.HOLE if orbits else ViewControls.Gaze.FREE
	controls.mode = ViewControls.Mode.RIDE
	if kind == Kind.FROM_REST or kind == Kind.AS_RAIN:
		controls.rig.look_from(ride.get_place(), _up())
	_take_along()
	started.emit()
	return true


## Ends the ride where it is.
func leave() -> void:
	if not is_on():
		return
	ride = null
	switches.want_hole(true)
	controls.mode = _mode_before
	choice.resume(controls.rig.get_position())
	left.emit()


## Lets `seconds` pass.
func advance(seconds: float) -> void:
	if not is_on():
		return
	var orientation := controls.rig.get_orientation()
	if ride is VelocityRide:
		(ride as VelocityRide).set_held(pace.paused)
		(ride as VelocityRide).look_along(orientation * Vector3.FORWARD)
	ride.steer(orientation * controls.asked_flight(), seconds)
	var radius := ride.get_place().length()
	var passed := pace.passed(radius, seconds)
	var scrub := _asked_scrub()
	if scrub != 0.0:
		passed = scrub * SCRUB * RidePace.SHARE * pow(radius, 1.5) * seconds
	if passed != 0.0 and not ride.advance(passed) and scrub == 0.0:
		_end()
	_take_along()
	if ride.get_place().length() > ViewRig.FARTHEST:
		warned.emit(TOPIC, tr("The ride ends here: it has left the hole far behind."))
		leave()


func toggle_pause() -> void:
	if not is_on():
		return
	# From the end there is only the way back.
	if pace.paused and not pace.reversed and ride.is_reversible() and ride.get_progress() >= 1.0:
		ride.seek(0.0)
	pace.paused = not pace.paused


func reverse() -> void:
	if not is_on():
		return
	if not ride.is_reversible():
		warned.emit(
			TOPIC, tr("This flight has no way back: only falls and orbits can be reversed.")
		)
		return
	pace.reversed = not pace.reversed
	pace.paused = false


## Slower or faster: time, or the top speed of the flight without the hole.
func change_pace(steps: int) -> void:
	if ride is VelocityRide:
		(ride as VelocityRide).change_top_speed(steps)
	elif is_on():
		pace.change(steps)


## Goes to a place along the ride, 0 to 1.
func seek(progress: float) -> void:
	if is_on() and ride.is_reversible():
		ride.seek(progress)
		_take_along()


func _make(kind: Kind) -> Ride:
	var place := controls.rig.get_position()
	var made: Ride
	match kind:
		Kind.FROM_REST:
			made = FallRide.from_rest(HIGH, place)
		Kind.AS_RAIN:
			made = FallRide.as_rain(HIGH, place)
		Kind.DROPPED:
			made = FallRide.from_rest(place.length(), place)
		Kind.ORBIT_RIGHT:
			made = OrbitRide.from(place, _up())
		Kind.ORBIT_LEFT:
			made = OrbitRide.from(place, -_up())
		Kind.PILOTED:
			made = PilotedRide.from(place, _present_celerity(place))
		_:
			var view := controls.rig.get_orientation() * Vector3.FORWARD
			made = VelocityRide.from(place, view)
	return made


# A flight goes on with the motion that is there.
func _present_celerity(place: Vector3) -> Vector3:
	if ride != null and ride.has_hole():
		return ride.get_celerity()
	var observer := sky.observer if sky.observer != null else SkyObserver.new()
	return observer.celerity_at(place) if observer.get_refusal(place).is_empty() else Vector3.ZERO


func _asked_scrub() -> float:
	if not (ride.is_reversible() and controls.listening and controls.keys_listening):
		return 0.0
	return Input.get_axis(&"ride_back", &"ride_ahead")


func _end() -> void:
	pace.paused = true
	if not ride.is_reversible():
		warned.emit(TOPIC, tr("The flight ends here, just before the centre."))
		leave()
	elif ride.get_progress() >= 0.5:
		warned.emit(TOPIC, tr("The ride ends here, just before the centre. It can be reversed."))
	else:
		pace.reversed = false


func _take_along() -> void:
	controls.rig.move_to(ride.get_place())
	ride.set_motion(_observer)
	sky.observer = _observer
	if ride.has_hole():
		var shadow := _observer.shadow(ride.get_place())
		controls.hole_direction = shadow.get("direction", Vector3.FORWARD)


func _up() -> Vector3:
	return controls.rig.get_orientation() * Vector3.UP


static func _translated(text: String) -> String:
	return TranslationServer.translate(text)
