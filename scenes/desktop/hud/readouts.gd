# SPDX-License-Identifier: MIT
class_name Readouts
extends PanelContainer
## Shows where the eye is, how it moves and how large the shadow looks.

## Seconds between two updates: numbers that flicker cannot be read.
const INTERVAL: float = 0.1

@export var sky: BlackHoleSky
@export var controls: ViewControls
@export var director: RideDirector

var _elapsed: float = INTERVAL

@onready var _distance: Label = %Distance
@onready var _kilometres: Label = %Kilometres
@onready var _speed_caption: Label = %SpeedCaption
@onready var _speed: Label = %Speed
@onready var _inside: Label = %Inside
@onready var _observer: Label = %Observer
@onready var _shadow: Label = %Shadow
@onready var _frames: Label = %Frames
@onready var _motion: Label = %Motion
@onready var _picture: Label = %Picture


func _process(delta: float) -> void:
	_elapsed += delta
	if _elapsed >= INTERVAL and is_visible_in_tree():
		_elapsed = 0.0
		update()


func update() -> void:
	var distance := controls.rig.get_distance()
	_show_figure(distance)
	_inside.visible = distance <= sky.lensing
	_observer.text = _observer_text()
	_speed.text = _speed_text()
	var shadow := sky.shadow_angle_at(_eye())
	_shadow.text = ReadoutText.NOTHING
	if shadow > 0.0:
		_shadow.text = tr("%s across") % ReadoutText.angle(shadow)
	_frames.text = tr("%d per second") % roundi(Engine.get_frames_per_second())
	var lensing := tr("lensing on") if sky.lensing > 0.5 else tr("lensing off")
	_motion.text = "%s  ·  %s" % [_mode_text(), lensing]
	_picture.text = (
		"%s  ·  %s  ·  %s"
		% [
			ReadoutText.background(sky.background),
			ReadoutText.image_orders(sky.image_orders),
			_exposure_text(),
		]
	)


func _exposure_text() -> String:
	var text := ReadoutText.exposure(sky.get_effective_exposure())
	return tr("auto, %s") % text if sky.auto_exposure else text


func _eye() -> Vector3:
	return sky.to_global(controls.rig.get_position() * sky.schwarzschild_radius)


func _observer_text() -> String:
	if sky.observer_motion != LensingTable.MOTION_INFALL:
		return ReadoutText.observer(sky.observer_motion)
	var way := tr("rising, energy %s") if sky.observer.outgoing else tr("falling, energy %s")
	return way % ReadoutText.significant(sky.observer.energy)


# The distance; on a flight without the hole, where there is nothing to be distant from, the speed.
func _show_figure(distance: float) -> void:
	var among_stars := director.is_on() and not director.ride.has_hole()
	_speed.visible = not among_stars
	_speed_caption.visible = not among_stars
	if among_stars:
		var celerity := director.ride.get_celerity().length()
		_distance.text = ReadoutText.speed(ObserverSpeed.from_celerity(celerity))
		_kilometres.text = "γ %s" % ReadoutText.significant(sqrt(1.0 + celerity * celerity))
	else:
		_distance.text = ReadoutText.distance(distance)
		_kilometres.text = ReadoutText.kilometres(distance, sky.get_length_unit_km())


# Of the motion that is shown: relative to the static observer outside, to rain inside.
func _speed_text() -> String:
	if sky.lensing < ObserverChoice.NO_HOLE:
		return ReadoutText.speed(0.0)
	var place := controls.rig.get_position() / sky.lensing
	var observer := sky.observer if sky.observer != null else SkyObserver.new()
	if not observer.get_refusal(place).is_empty():
		return ReadoutText.NOTHING
	var text := ReadoutText.speed(ObserverSpeed.of(observer.celerity_at(place), place))
	return tr("%s against rain") % text if place.length() <= 1.0 else text


func _mode_text() -> String:
	match controls.mode:
		ViewControls.Mode.ORBIT:
			return tr("orbit")
		ViewControls.Mode.FLIGHT:
			return tr("free flight")
	match controls.gaze:
		ViewControls.Gaze.HOLE:
			return tr("ride, looking at the hole")
		ViewControls.Gaze.AWAY:
			return tr("ride, looking back")
	return tr("ride, looking freely")
