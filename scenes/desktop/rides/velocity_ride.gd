# SPDX-License-Identifier: MIT
class_name VelocityRide
extends Ride
## A flight under special relativity alone: no hole, the stick sets the velocity, and aberration and
## Doppler effect do all. The stars are so far that the eye stays among them.
##
## Times are in seconds, those of the viewer.

## Speeds at full deflection, in units of c.
const SPEEDS: PackedFloat64Array = [0.1, 0.3, 0.5, 0.7, 0.9, 0.99, 0.999]
## Seconds in which 63 % of a change of rapidity is made.
const SETTLING: float = 0.8

var _speed_step: int = 4
var _held: bool = false
var _rapidity := EasedRate.new(SETTLING)
var _place: Vector3
var _proper_time: float = 0.0
var _star_time: float = 0.0
## Unit vector; in its direction far clocks are looked at.
var _view := Vector3.FORWARD


static func from(place: Vector3, view: Vector3) -> VelocityRide:
	var ride := new()
	ride._place = place
	ride._view = view
	return ride


func get_title() -> String:
	return _translated("Flight without the hole, up to %s c") % ReadoutText.plain(get_top_speed())


func get_place() -> Vector3:
	return _place


## Relative to the stars.
func get_celerity() -> Vector3:
	var rapidity := _rapidity.get_rate()
	var size := rapidity.length()
	return rapidity * (sinh(size) / size) if size > 1e-6 else rapidity


func get_proper_time() -> float:
	return _proper_time


## The stars' own time.
func get_rain_time() -> float:
	return _star_time


## Seen in the middle of the picture: 1 / (gamma (1 - beta . n)).
func get_far_clock_rate() -> float:
	var celerity := get_celerity()
	return 1.0 / (sqrt(1.0 + celerity.length_squared()) - celerity.dot(_view))


func is_reversible() -> bool:
	return false


func has_hole() -> bool:
	return false


func get_top_speed() -> float:
	return SPEEDS[_speed_step]


## One step more or less of the speed at full deflection.
func change_top_speed(steps: int) -> void:
	_speed_step = clampi(_speed_step + steps, 0, SPEEDS.size() - 1)


## Whether the velocity stays as it is, whatever the stick does.
func set_held(held: bool) -> void:
	_held = held


func look_along(view: Vector3) -> void:
	_view = view


func steer(wish: Vector3, seconds: float) -> void:
	var target := wish.limit_length() * atanh(get_top_speed())
	_rapidity.advance(_rapidity.get_rate() if _held else target, seconds)
	_proper_time += seconds
	_star_time += seconds * sqrt(1.0 + get_celerity().length_squared())


func advance(_time: float) -> bool:
	return true


## While the hole is fading the velocity is relative to who hovers at its place, if anybody can.
func set_motion(observer: SkyObserver) -> void:
	observer.motion = LensingTable.MOTION_VELOCITY
	observer.relative_to_static = _place.length() > 1.0
	observer.celerity = get_celerity()
