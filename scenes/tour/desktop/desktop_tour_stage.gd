# SPDX-License-Identifier: MIT
class_name DesktopTourStage
extends TourStage
## Shows a tour in the desktop scene: moves its eye, its rides and its sky, and puts all back.
##
## A ride that is on when a tour begins is left. Keys and sticks steer nothing but the tour.

enum Way { NONE, GLIDE, DARKEN, BRIGHTEN }

## Seconds in which the picture goes dark, and comes back.
const DARKEN_SECONDS: float = 0.45
const BRIGHTEN_SECONDS: float = 0.7
## Seconds in which 63 % of a turn of the eye on a ride is made.
const TURNING: float = 0.9
## A ride that is farther off than this ratio of radii goes to where a caption belongs, by hand.
const NEAR: float = 1.02
## Seconds in which 63 % of the way is made that the picture moves up for the words, and the most of
## its height that counts as covered by them.
const SHIFTING: float = 0.8
const MOST_COVERED: float = 0.4

@export var sky: BlackHoleSky
@export var camera: Camera3D
@export var controls: ViewControls
@export var director: RideDirector
@export var choice: ObserverChoice
@export var switches: SkySwitches
@export var disk: DiskSwitches
@export var overlays: SkyOverlays
@export var router: ActionRouter
@export var captions: TourCaptions
## Closed during a tour; may be none.
@export var map: MapWindow
## Not seen during a tour.
@export var hidden: Array[CanvasItem] = []
## Do nothing during a tour.
@export var resting: Array[Node] = []

var _station: TourStation
var _caption: int = 0
var _view := TourView.new()
var _from := TourView.new()
var _to := TourView.new()
var _covered: float = 0.0
var _pace: int = 0
var _way: Way = Way.NONE
var _gone: float = 0.0
var _duration: float = 0.0
var _sky := TourSky.new()
var _hovering := SkyObserver.new()
# What was before the tour.
var _memory := KeptProperties.new()
var _place: Vector3
var _orientation: Quaternion
var _map_was_open: bool = false


func begin() -> void:
	director.leave()
	_map_was_open = map != null and map.visible
	if _map_was_open:
		map.close()
	_place = controls.rig.get_position()
	_orientation = controls.rig.get_orientation()
	_memory.keep(controls, [&"mode", &"gaze", &"listening"])
	_memory.keep(camera, [&"fov"])
	_memory.keep(router, [&"restricted"])
	for item in hidden:
		_memory.keep(item, [&"visible"])
	for node in resting:
		node.set_process(false)
	_sky.sky = sky
	_sky.switches = switches
	_sky.disk = disk
	_sky.overlays = overlays
	_sky.remember()
	choice.resting = true
	controls.mode = ViewControls.Mode.FLIGHT
	sky.observer = _hovering
	_covered = 0.0
	_view = TourView.of_rig(controls.rig, camera.fov)
	_hold_the_rest()


func arrive(station: TourStation) -> void:
	_station = station
	_caption = 0
	var glides := station.arrival == TourStation.Arrival.GLIDE and not director.is_on()
	if glides and station.motion != TourStation.Motion.FALL_FROM_INFINITY and _way != Way.DARKEN:
		_sky.show_station(station)
		_glide(TourView.of_station(station), station.travel_seconds)
	elif _way != Way.DARKEN:
		_start(Way.DARKEN, DARKEN_SECONDS)


func is_arrived() -> bool:
	return _way == Way.NONE or (_way == Way.BRIGHTEN and _gone > 0.5 * _duration)


func show_caption(index: int, by_hand: bool) -> void:
	_caption = index
	if _way == Way.DARKEN:
		return
	_sky.show_caption(index)
	if director.is_on():
		_set_pace()
		if by_hand:
			_seek(_station.captions[index].radius)
		return
	var wanted := TourView.of_station(_station, index)
	if _way == Way.GLIDE:
		_to = wanted
	elif not _view.is_like(wanted):
		_glide(wanted, _station.travel_seconds)


func is_ready_for(caption: TourCaption) -> bool:
	if not director.is_on() or caption.radius <= 0.0 or director.pace.paused:
		return true
	return director.ride.get_place().length() <= caption.radius


func set_paused(paused: bool) -> void:
	if director.is_on():
		director.pace.paused = paused or _is_at_end()


func advance(seconds: float) -> void:
	_hold_the_rest()
	_sky.advance(seconds)
	_gone += seconds
	match _way:
		Way.GLIDE:
			_show(TourView.between(_from, _to, smoothstep(0.0, _duration, _gone)))
		Way.DARKEN:
			captions.darkness = _gone / _duration
		Way.BRIGHTEN:
			captions.darkness = 1.0 - _gone / _duration
	if _way != Way.NONE and _gone >= _duration:
		_end_way()
	if director.is_on():
		_watch_ride(seconds)
	var covered := minf(captions.get_covered_share(), MOST_COVERED)
	_covered = lerpf(covered, _covered, exp(-seconds / SHIFTING))
	TourLens.show_above(camera, _covered)


func leave() -> void:
	_way = Way.NONE
	# First, so that the observer before the tour is one who can be there.
	controls.rig.place(_place, _orientation)
	director.leave()
	controls.rig.place(_place, _orientation)
	_memory.restore()
	TourLens.show_whole(camera)
	for node in resting:
		node.set_process(true)
	choice.resume(_place)
	_sky.restore()
	if _map_was_open:
		map.open()
	captions.darkness = 1.0
	captions.brighten(BRIGHTEN_SECONDS)


func _glide(to: TourView, seconds: float) -> void:
	captions.darkness = 0.0
	_from = _view.copy()
	_to = to
	_start(Way.GLIDE, seconds)


func _start(way: Way, seconds: float) -> void:
	_way = way
	_gone = 0.0
	_duration = maxf(seconds, 0.01)


func _end_way() -> void:
	if _way == Way.DARKEN:
		_cut()
		_start(Way.BRIGHTEN, BRIGHTEN_SECONDS)
		return
	captions.darkness = 0.0
	_way = Way.NONE
	if _station.motion != TourStation.Motion.HOVER and not director.is_on():
		_begin_ride()


# In the dark.
func _cut() -> void:
	if director.is_on():
		controls.rig.place(_place, _orientation)
		director.leave()
		choice.resting = true
		sky.observer = _hovering
		controls.mode = ViewControls.Mode.FLIGHT
	_sky.show_station(_station)
	_sky.show_caption(_caption)
	_sky.advance(INF)
	_covered = minf(captions.get_covered_share(), MOST_COVERED)
	_show(TourView.of_station(_station, _caption))
	if _station.motion != TourStation.Motion.HOVER:
		_begin_ride()
	if sky.auto_exposure:
		sky.adapt_at_once()


func _show(view: TourView) -> void:
	_view = view
	controls.rig.place(view.get_place(), view.get_orientation())
	camera.fov = view.get_field()


func _begin_ride() -> void:
	controls.rig.place(_station.get_place(), _view.get_orientation())
	match _station.motion:
		TourStation.Motion.FALL_FROM_REST:
			director.start(RideDirector.Kind.DROPPED)
		TourStation.Motion.ORBIT:
			director.start(RideDirector.Kind.ORBIT_RIGHT)
		TourStation.Motion.FALL_FROM_INFINITY:
			director.start(RideDirector.Kind.AS_RAIN)
			_seek(_station.radius)
			var axes := Basis(_view.get_orientation())
			controls.rig.place(director.ride.get_place(), axes.get_rotation_quaternion())
	controls.gaze = ViewControls.Gaze.FREE
	_pace = 0
	_set_pace()
	if _caption > 0:
		_seek(_station.captions[_caption].radius)


func _watch_ride(seconds: float) -> void:
	if _is_at_end():
		director.pace.paused = true
	controls.rig.face(_wanted_direction(), 1.0 - exp(-seconds / TURNING))
	_view = TourView.of_rig(controls.rig, camera.fov)


# Aberration shows the hole elsewhere than it is.
func _wanted_direction() -> Vector3:
	match _station.get_look_at(_caption):
		TourStation.Look.AWAY:
			return -controls.hole_direction
		TourStation.Look.ALONG:
			var right := controls.hole_direction.cross(controls.rig.get_orientation() * Vector3.UP)
			return right.normalized()
	return controls.hole_direction


func _set_pace() -> void:
	var wanted := _station.pace + _station.captions[_caption].pace_change
	director.pace.change(wanted - _pace)
	_pace = wanted


func _seek(radius: float) -> void:
	var fall := director.ride as FallRide
	if fall == null or radius <= 0.0:
		return
	if absf(log(fall.get_radius() / radius)) > log(NEAR):
		director.seek(fall.progress_of(radius))


func _is_at_end() -> bool:
	return director.ride is FallRide and director.ride.get_place().length() <= _station.waits_at


# Others may have let go of it.
func _hold_the_rest() -> void:
	controls.listening = false
	router.restricted = true
	for item in hidden:
		item.hide()
