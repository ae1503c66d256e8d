# SPDX-License-Identifier: MIT
class_name XrTourStage
extends TourStage
## Shows a tour in the headset scene. The visitor is never driven: places change in a blink, and
## only the rides of a tour glide.
##
## Where a station stands, the hole is so large that one's own head is small beside it. The sky is
## turned, not the room: what a station looks at is ahead of the visitor, level.

## The hole's radius during a tour, metres.
@export_range(5.0, 100.0, 1.0, "suffix:m") var metres: float = 30.0
@export var sky: BlackHoleSky
@export var rig: XrRig
@export var choice: ObserverChoice
@export var switches: SkySwitches
@export var disk: DiskSwitches
## Off meanwhile; may be none.
@export var near_limit: NearLimit

var ride: Ride
var pace := RidePace.new()

var _station: TourStation
var _caption: int = 0
var _is_there: bool = false
var _radius_shown: float = 0.0
var _outward := Vector3.BACK
var _seat: Vector3
var _sky := TourSky.new()
var _hovering := SkyObserver.new()
var _moving := SkyObserver.new()
# What was before the tour.
var _memory := KeptProperties.new()
var _room: Transform3D
var _sky_before: Transform3D


func begin() -> void:
	_room = rig.get_room()
	_sky_before = sky.global_transform
	_memory.keep(sky, [&"schwarzschild_radius"])
	if near_limit != null:
		_memory.keep(near_limit, [&"enabled"])
	_sky.sky = sky
	_sky.switches = switches
	_sky.disk = disk
	_sky.in_headset = true
	_sky.remember()
	choice.resting = true


func arrive(station: TourStation) -> void:
	_station = station
	_caption = 0
	_is_there = false
	rig.blink(_stand)


func is_arrived() -> bool:
	return _is_there and not rig.is_blinking()


func show_caption(index: int, by_hand: bool) -> void:
	_caption = index
	if not _is_there:
		return
	if ride != null:
		_sky.show_caption(index)
		_set_pace()
		if by_hand:
			_seek(_station.captions[index].radius)
	elif not is_equal_approx(_radius_shown, _station.get_radius_at(index)):
		_is_there = false
		rig.blink(_stand)
	else:
		_sky.show_caption(index)


func words_of(caption: TourCaption) -> String:
	return caption.text if caption.headset_text.is_empty() else caption.headset_text


func is_ready_for(caption: TourCaption) -> bool:
	if ride == null or caption.radius <= 0.0 or _is_at_end():
		return true
	return ride.get_place().length() <= caption.radius


func set_paused(paused: bool) -> void:
	pace.paused = paused


func advance(seconds: float) -> void:
	_sky.advance(seconds)
	if ride == null or not _is_there:
		return
	if not _is_at_end():
		ride.advance(pace.passed(ride.get_place().length(), seconds))
	_take_along()


func leave() -> void:
	_station = null
	ride = null
	_is_there = false
	_memory.restore()
	sky.global_transform = _sky_before
	choice.resume((_room.origin - sky.global_position) / sky.schwarzschild_radius)
	_sky.restore()
	rig.set_room(_room)


# While it is dark.
func _stand() -> void:
	if _station == null:
		return
	var ahead := -XrRig.backwards(rig.head.global_basis)
	var towards := ahead
	match _station.get_look_at(_caption):
		TourStation.Look.AWAY:
			towards = -ahead
		TourStation.Look.ALONG:
			towards = ahead.rotated(Vector3.UP, 0.5 * PI)
	_outward = -towards
	var turned := Basis.looking_at(towards, Vector3.UP)
	sky.global_basis = turned * Basis(TourView.of_station(_station).frame).inverse()
	sky.schwarzschild_radius = metres
	if near_limit != null:
		near_limit.enabled = false
	_radius_shown = _station.get_radius_at(_caption)
	if _station.motion != TourStation.Motion.HOVER:
		_radius_shown = _station.radius
	_sky.show_station(_station)
	_sky.show_caption(_caption)
	_sky.advance(INF)
	ride = _make_ride()
	sky.observer = _moving if ride != null else _hovering
	rig.jump_to(_outward * _radius_shown * metres)
	_seat = rig.get_seat()
	if ride != null:
		_seek(_station.captions[_caption].radius)
		_take_along()
	_is_there = true


func _make_ride() -> Ride:
	_set_pace()
	var made: FallRide
	match _station.motion:
		TourStation.Motion.FALL_FROM_REST:
			# From a little farther out: who leans back must not be where the fall never was.
			made = FallRide.from_rest(_station.radius + XrRides.LEANING, _outward)
		TourStation.Motion.FALL_FROM_INFINITY:
			made = FallRide.as_rain(maxf(RideDirector.HIGH, _station.radius), _outward)
		TourStation.Motion.ORBIT:
			return OrbitRide.from(_outward * _station.radius, Vector3.UP)
		_:
			return null
	made.seek(made.progress_of(_station.radius))
	return made


func _take_along() -> void:
	rig.glide_seat_to(_seat, ride.get_place() * metres)
	ride.set_motion(_moving)
	# The ride goes along the world's axes, the observer moves along the sky's.
	_moving.axis = sky.global_basis.inverse() * _moving.axis
	sky.observer = _moving


func _set_pace() -> void:
	var paused := pace.paused
	pace.reset()
	pace.change(_station.pace + _station.captions[_caption].pace_change)
	pace.paused = paused


func _seek(radius: float) -> void:
	var fall := ride as FallRide
	if fall != null and radius > 0.0:
		fall.seek(fall.progress_of(radius))


func _is_at_end() -> bool:
	return ride is FallRide and ride.get_place().length() <= _station.waits_at
