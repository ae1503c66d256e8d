# SPDX-License-Identifier: MIT
class_name SkyOverlays
extends Node
## Lines and names over the sky. What they need is read when it is first wanted; the constellations,
## which take a quarter of a second, on a worker thread.

## Something cannot be shown.
signal warned(topic: StringName, text: String)

const CONSTELLATIONS: StringName = &"constellations"
const STAR_NAMES: StringName = &"star_names"
## What belongs to hole and observer.
const OF_HOLE: int = (
	BlackHoleSky.OVERLAY_SHADOW_EDGE
	| BlackHoleSky.OVERLAY_EINSTEIN_RINGS
	| BlackHoleSky.OVERLAY_MOTION
	| BlackHoleSky.OVERLAY_SHADOW_DIAMETER
	| BlackHoleSky.OVERLAY_STRAIGHT_LIGHT
)

@export_file("*.json") var figures_file: String = ConstellationFigures.FILE
@export_file("*.csv") var names_file: String = StarNames.FILE
@export var sky: BlackHoleSky
@export var labels: SkyLabels

## Which of those of the hole come with the key: those that were on last.
var _of_hole: int = OF_HOLE & ~BlackHoleSky.OVERLAY_SHADOW_DIAMETER
var _constellations_wanted: bool = false
var _task: int = -1
# The worker's; nobody else touches them until it is done.
var _figures: ConstellationFigures
var _faces: Array[Image] = []


func _ready() -> void:
	set_process(false)


func _exit_tree() -> void:
	if _task >= 0:
		WorkerThreadPool.wait_for_task_completion(_task)
		_task = -1


func _process(_delta: float) -> void:
	if _task >= 0 and WorkerThreadPool.is_task_completed(_task):
		WorkerThreadPool.wait_for_task_completion(_task)
		_task = -1
		set_process(false)
		_take_constellations()


## Whether the constellations are shown, or will be as soon as they are read.
func are_constellations_wanted() -> bool:
	return _constellations_wanted


func are_star_names_shown() -> bool:
	return labels.stars_shown


func is_computing() -> bool:
	return _task >= 0


## Figures of the constellations and their names.
func want_constellations(wanted: bool) -> void:
	_constellations_wanted = wanted
	if wanted and sky.figure_field == null and _task < 0:
		_task = WorkerThreadPool.add_task(_read_constellations, false, "Constellations")
		set_process(true)
	elif _task < 0:
		_show_constellations()


## Names of bright stars.
func want_star_names(wanted: bool) -> void:
	if wanted and labels.stars.names.is_empty():
		labels.stars = StarNames.load_file(names_file)
	var error := labels.stars.error
	labels.stars_shown = wanted and error.is_empty()
	if wanted and not error.is_empty():
		warned.emit(STAR_NAMES, tr("Star names cannot be shown.") + "\n" + error)


## Constellations and star names together: all off when any is on.
func toggle_names() -> void:
	var wanted := not (_constellations_wanted or labels.stars_shown)
	want_constellations(wanted)
	want_star_names(wanted)


## What belongs to hole and observer: off when any is on, else what was on last.
func toggle_of_hole() -> void:
	var shown := sky.overlays & OF_HOLE
	if shown != 0:
		_of_hole = shown
		sky.overlays &= ~OF_HOLE
	else:
		sky.overlays |= _of_hole


## Switches one of [enum BlackHoleSky.Overlay]; the constellations are not for here.
func want(overlay: BlackHoleSky.Overlay, wanted: bool) -> void:
	sky.overlays = sky.overlays | overlay if wanted else sky.overlays & ~overlay


# On a worker thread.
func _read_constellations() -> void:
	_figures = ConstellationFigures.load_file(figures_file)
	_faces = ConstellationOverlay.bake_faces(_figures)


func _take_constellations() -> void:
	if _figures.error.is_empty():
		labels.figures = _figures
		sky.figure_field = ConstellationOverlay.join_faces(_faces)
	else:
		_constellations_wanted = false
		warned.emit(CONSTELLATIONS, tr("Constellations cannot be shown.") + "\n" + _figures.error)
	_faces = []
	_show_constellations()


func _show_constellations() -> void:
	labels.constellations_shown = _constellations_wanted
	want(BlackHoleSky.OVERLAY_CONSTELLATIONS, _constellations_wanted)
