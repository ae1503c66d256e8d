# SPDX-License-Identifier: MIT
class_name MapWindow
extends Control
## The right half of the window: a map of the whole sky beside the first-person picture, how far the
## hole is, and who sees it.

## Opened or closed.
signal toggled(open: bool)

## Seconds between two updates of the controls.
const INTERVAL: float = 0.1

@export var sky: BlackHoleSky
@export var disk: AccretionDisk
@export var controls: ViewControls
@export var choice: ObserverChoice
@export var director: RideDirector
@export var labels: SkyLabels

var _elapsed: float = 0.0
var _projection_before: BlackHoleSky.Projection = BlackHoleSky.PROJECTION_PERSPECTIVE

@onready var _view: MapView = %MapView
@onready var _controls: Control = %MapControls
@onready var _radius: RideTrack = %Radius
@onready var _radius_value: Label = %RadiusValue
@onready var _observer: Stepper = %MapObserver
@onready var _projection: Stepper = %MapProjection


func _ready() -> void:
	_view.sky = sky
	_view.disk = disk
	_view.controls = controls
	_view.labels = labels
	_radius.mark = share_of(1.0)
	_radius.value_changed.connect(_on_radius_changed)
	_observer.chosen.connect(_on_observer_chosen)
	_projection.chosen.connect(func(at: int) -> void: set_projection(_map_at(at)))
	set_process(false)


func _process(delta: float) -> void:
	SplitPicture.show_beside(controls.camera, 0.5)
	_view.follow()
	_elapsed += delta
	if _elapsed >= INTERVAL:
		refresh()


func toggle() -> void:
	if visible:
		close()
	else:
		open()


func open() -> void:
	if visible:
		return
	_projection_before = sky.projection
	sky.projection = BlackHoleSky.PROJECTION_PERSPECTIVE
	show()
	set_process(true)
	refresh()
	_view.open()
	toggled.emit(true)


func close() -> void:
	if not visible:
		return
	hide()
	set_process(false)
	_view.close()
	SplitPicture.show_whole(controls.camera)
	if sky.projection == BlackHoleSky.PROJECTION_PERSPECTIVE:
		sky.projection = _projection_before
	toggled.emit(false)


func get_projection() -> BlackHoleSky.Projection:
	return _view.projection


## Which map is shown; perspective is none.
func set_projection(projection: BlackHoleSky.Projection) -> void:
	_view.projection = projection


func refresh() -> void:
	_elapsed = 0.0
	var distance := controls.rig.get_distance()
	_controls.visible = not director.is_on()
	_radius.set_value_no_signal(share_of(distance))
	_radius_value.text = ReadoutText.distance(distance)
	var kinds := PackedStringArray()
	for kind: ObserverKind.Kind in ObserverKind.Kind.values():
		kinds.append(ObserverKind.title(kind))
	_observer.titles = kinds
	_observer.at = choice.get_kind()
	_projection.titles = PicturePage.projection_titles().slice(1)
	_projection.at = _view.projection - BlackHoleSky.PROJECTION_EQUIRECTANGULAR


## Where a radius in Schwarzschild radii is on the slider, 0 to 1: evenly in its logarithm.
static func share_of(radius: float) -> float:
	return log(radius / ViewRig.NEAREST) / log(ViewRig.FARTHEST / ViewRig.NEAREST)


## The inverse of [method share_of].
static func radius_at(share: float) -> float:
	return ViewRig.NEAREST * (ViewRig.FARTHEST / ViewRig.NEAREST) ** share


func _map_at(at: int) -> BlackHoleSky.Projection:
	return (at + BlackHoleSky.PROJECTION_EQUIRECTANGULAR) as BlackHoleSky.Projection


func _on_radius_changed(share: float) -> void:
	if not director.is_on():
		controls.rig.move_to(controls.rig.get_position().normalized() * radius_at(share))
	refresh()


func _on_observer_chosen(at: int) -> void:
	var up := controls.rig.get_orientation() * Vector3.UP
	choice.choose(at as ObserverKind.Kind, controls.rig.get_position(), up)
	refresh()
