# SPDX-License-Identifier: MIT
class_name PhotoMode
extends MenuScreen
## Composes and takes photos of the running scene: time stands still, the camera can be moved, the
## rest of the display is hidden. Each photo has the JSON beside it from which ./run capture draws
## it again.

## Both files of a photo are there.
signal saved(picture: String, shot: String)
## A photo could not be taken; the screen says why as well.
signal failed(reason: String)

const BAR_ACTION: StringName = &"photo_bar"
## What the bar changes, to be put back.
const SKY_PROPERTIES: Array[StringName] = [
	&"exposure", &"auto_exposure", &"psf_model", &"aperture_mm"
]
## Actions that others would answer to, were they not kept back here.
const KEPT_BACK: Array[StringName] = [&"toggle_help", &"toggle_menu"]
const NOTE_SECONDS: float = 8.0
const HINT_SECONDS: float = 3.0

@export var sky: BlackHoleSky
@export var disk: AccretionDisk
@export var camera: Camera3D
@export var controls: ViewControls
@export var router: ActionRouter
@export var map: MapWindow
@export var labels: SkyLabels
## What gives way to the photo mode.
@export var display: Control
## What stands still meanwhile; the disk's own time does as well.
@export var resting: Array[Node]

## Where photos go; empty: the user's folder for pictures.
var folder: String = ""

var _before := KeptProperties.new()
var _map_was_open: bool = false
var _disk_pace: float = 0.0

@onready var _bar: PhotoBar = %Bar
@onready var _grid: ThirdsGrid = %Grid
@onready var _note: FadingNote = %Note
@onready var _hint: FadingNote = %HiddenHint
@onready var _taker: PhotoTaker = %Taker


func _enter_tree() -> void:
	var bar: PhotoBar = %Bar
	bar.sky = sky
	bar.camera = camera
	bar.controls = controls


func _ready() -> void:
	name_action()
	hide()
	_bar.save_asked.connect(save)
	_bar.thirds_toggled.connect(func(shown: bool) -> void: _grid.visible = shown)
	_bar.done.connect(close)
	_taker.saved.connect(_on_saved)
	_taker.failed.connect(_on_failed)


func _unhandled_input(event: InputEvent) -> void:
	if not visible:
		return
	if event.is_action_pressed(BAR_ACTION):
		get_viewport().set_input_as_handled()
		show_bar(not _bar.visible)
	elif event.is_action_pressed(&"ui_cancel"):
		get_viewport().set_input_as_handled()
		if _bar.visible:
			close()
		else:
			show_bar(true)
	elif KEPT_BACK.any(_is_pressed.bind(event)):
		get_viewport().set_input_as_handled()


## Gives the action that shows and hides the bar its key and button, where the project has none.
static func name_action() -> void:
	if InputMap.has_action(BAR_ACTION):
		return
	InputMap.add_action(BAR_ACTION)
	var key := InputEventKey.new()
	key.physical_keycode = KEY_H
	InputMap.action_add_event(BAR_ACTION, key)
	var button := InputEventJoypadButton.new()
	button.button_index = JOY_BUTTON_Y
	InputMap.action_add_event(BAR_ACTION, button)


func get_first_focus() -> Control:
	return _bar.get_first_focus()


func is_busy() -> bool:
	return _taker.is_busy()


func is_bar_shown() -> bool:
	return _bar.visible


## Without the bar keys and sticks move the camera; with it they go through the bar.
func show_bar(shown: bool) -> void:
	_bar.visible = shown
	controls.keys_listening = not shown
	if shown:
		_bar.refresh()
		_bar.get_first_focus().grab_focus()
	_hint.hide()
	if not shown:
		_hint.tell(tr("Show the bar: %s or %s") % _bindings(), HINT_SECONDS)


## Takes a photo of a kind, "png" or "exr", as large as the bar says or as `resolution` does.
func save(kind: String, resolution := Vector2i.ZERO) -> void:
	if _taker.is_busy():
		return
	if kind == "exr" and RenderingServer.get_current_rendering_method() != "forward_plus":
		_on_failed(tr("EXR needs the renderer Forward+: choose it in the settings, or save a PNG."))
		return
	var size_wanted := _bar.get_resolution() if resolution == Vector2i.ZERO else resolution
	var described := ShotFromScene.describe(sky, camera, size_wanted, disk, labels)
	if not described.refusal.is_empty():
		_on_failed(described.refusal)
		return
	var directory := folder if not folder.is_empty() else PhotoFiles.folder()
	var path := PhotoFiles.next_name(directory, PhotoFiles.today())
	if path.is_empty():
		_on_failed(tr("%s is full: move the photos elsewhere.") % directory)
		return
	_note.tell(tr("Taking the photo …"), INF)
	_taker.take(described, path, kind, sky)


func _on_open() -> void:
	_before.keep(sky, SKY_PROPERTIES)
	_before.keep(camera, [&"fov"])
	# What was metered last stays.
	sky.exposure = sky.get_effective_exposure()
	sky.auto_exposure = false
	_map_was_open = map != null and map.visible
	if _map_was_open:
		map.close()
	display.hide()
	router.restricted = true
	_hold_time(true)
	_note.hide()
	show_bar(true)


func _on_close() -> void:
	_before.restore()
	_taker.rest()
	if _map_was_open:
		map.open()
	display.show()
	router.restricted = false
	controls.keys_listening = true
	_hold_time(false)


func _hold_time(held: bool) -> void:
	for node in resting:
		node.set_process(not held)
	if disk == null:
		return
	if held:
		_disk_pace = disk.time_scale
		disk.time_scale = 0.0
	else:
		disk.time_scale = _disk_pace


func _bindings() -> Array[String]:
	return [BindingNames.keyboard([BAR_ACTION]), BindingNames.gamepad([BAR_ACTION])]


func _is_pressed(action: StringName, event: InputEvent) -> bool:
	return InputMap.has_action(action) and event.is_action_pressed(action)


func _on_saved(picture: String, shot: String) -> void:
	var ways := [
		tr("Saved: %s") % picture, tr("%s draws it again: ./run capture") % shot.get_file()
	]
	_note.tell("\n".join(ways), NOTE_SECONDS)
	saved.emit(picture, shot)
	if not visible:
		_taker.rest()


func _on_failed(reason: String) -> void:
	_note.tell(reason, NOTE_SECONDS)
	failed.emit(reason)
