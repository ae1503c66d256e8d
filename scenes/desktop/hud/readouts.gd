# SPDX-License-Identifier: MIT
class_name Readouts
extends PanelContainer
## Shows where the eye is, how it moves and how large the shadow looks.

## Seconds between two updates: numbers that flicker cannot be read.
const INTERVAL: float = 0.1

@export var sky: BlackHoleSky
@export var controls: ViewControls

var _elapsed: float = INTERVAL

@onready var _distance: Label = %Distance
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


## Angular diameter of the shadow as the sky is drawn now, in radians; NAN when there is no hole.
static func shadow_angle(of: BlackHoleSky, distance: float) -> float:
	if of.lensing < 1e-3 or of.table == null or not of.table.is_ready():
		return NAN
	return LensingTable.shadow_angle(distance / of.lensing, of.observer_motion)


func update() -> void:
	var distance := controls.rig.get_distance()
	var inside := distance <= sky.lensing
	_distance.text = ReadoutText.distance(distance)
	_inside.visible = inside
	_observer.text = ReadoutText.observer(sky.observer_motion)
	_shadow.text = tr("%s across") % ReadoutText.angle(shadow_angle(sky, distance))
	_frames.text = tr("%d per second") % roundi(Engine.get_frames_per_second())
	var mode := tr("orbit") if controls.mode == ViewControls.Mode.ORBIT else tr("free flight")
	var lensing := tr("lensing on") if sky.lensing > 0.5 else tr("lensing off")
	_motion.text = "%s  ·  %s" % [mode, lensing]
	_picture.text = (
		"%s  ·  %s  ·  %s"
		% [
			ReadoutText.background(sky.background),
			ReadoutText.image_orders(sky.image_orders),
			ReadoutText.exposure(sky.exposure),
		]
	)
