# SPDX-License-Identifier: MIT
class_name SkyPanel
extends PanelContainer
## The panel with everything that no key of its own reaches: effects, observers, rides, mass, lines
## and names, accretion disk. It can be gone through with the mouse, with the arrow keys alone and
## with a gamepad alone.

## Seconds between two updates.
const INTERVAL: float = 0.1

@export var sky: BlackHoleSky
@export var controls: ViewControls
@export var choice: ObserverChoice
@export var director: RideDirector
@export var overlays: SkyOverlays
@export var map: MapWindow
@export var disk: DiskSwitches
@export var disk_clock: DiskClock

var _elapsed: float = 0.0

@onready var _tabs: TabContainer = %Tabs
@onready var _effects: EffectsPage = %EffectsPage
@onready var _observer: ObserverPage = %ObserverPage
@onready var _rides: RidesPage = %RidesPage
@onready var _picture: PicturePage = %PicturePage
@onready var _disk: DiskPage = %DiskPage


# Before the pages are ready.
func _enter_tree() -> void:
	var effects: EffectsPage = %EffectsPage
	effects.sky = sky
	var observer: ObserverPage = %ObserverPage
	observer.sky = sky
	observer.choice = choice
	observer.controls = controls
	var rides: RidesPage = %RidesPage
	rides.director = director
	var picture: PicturePage = %PicturePage
	picture.sky = sky
	picture.overlays = overlays
	picture.map = map
	var disk_page: DiskPage = %DiskPage
	disk_page.switches = disk
	disk_page.clock = disk_clock


func _ready() -> void:
	_tabs.tab_changed.connect(_on_tab_changed)
	_rides.chosen.connect(hide)


func _process(delta: float) -> void:
	_elapsed += delta
	if visible and _elapsed >= INTERVAL:
		refresh()


func _unhandled_input(event: InputEvent) -> void:
	if visible and event.is_action_pressed(&"ui_cancel"):
		get_viewport().set_input_as_handled()
		hide()


func toggle() -> void:
	if visible:
		hide()
	else:
		open()


func open() -> void:
	refresh()
	show()
	_tabs.get_tab_bar().grab_focus()


func refresh() -> void:
	_elapsed = 0.0
	_tabs.set_tab_title(0, tr("Effects"))
	_tabs.set_tab_title(1, tr("Observer"))
	_tabs.set_tab_title(2, tr("Rides"))
	_tabs.set_tab_title(3, tr("Sky"))
	_tabs.set_tab_title(4, tr("Disk"))
	_effects.refresh(controls.rig.get_distance() <= sky.lensing)
	_observer.refresh()
	_rides.refresh()
	_picture.refresh()
	_disk.refresh()


func _on_tab_changed(_tab: int) -> void:
	if visible:
		refresh()
