# SPDX-License-Identifier: MIT
class_name ExhibitContent
extends Node
## Holds what visitors see, the scene for the screen or for the headset, and puts it back to how it
## was for the first visitor: it is freed and made anew, so that nothing can be left over.
##
## What the scene's menus offer beyond a visit, such as to quit, is taken out of it.

## The scene is new and can be shown.
signal renewed
## A station of the tour has begun.
signal station_begun(index: int)
## The visitor put the view straight.
signal reset_seen
## The tour has come to its end.
signal finished
## The headset's runtime has gone.
signal lost

const SCREEN_SCENE: String = "res://scenes/desktop/desktop.tscn"
const HEADSET_SCENE: String = "res://scenes/xr/xr.tscn"
## Buttons that an exhibit does not have: they lead out, fill the disk, or would have to be undone.
const KEPT_BACK: Array[StringName] = [&"Quit", &"Fullscreen", &"Photo", &"Settings"]
## On the command line, after --: fewer stars, for slow machines in tests.
const FEW_STARS: String = "--few-stars"

## Whether it is the headset's scene.
var with_headset: bool = false
## The tour to be led; empty: the scene's own.
var tour_file: String = ""
var scene: Node

var _packed: PackedScene
var _is_held: bool = true
# So that what is costly to load stays loaded while the scene changes.
var _kept: Texture2D


## Loads the scene; false: it is not there.
func prepare(headset: bool) -> bool:
	with_headset = headset
	var path := HEADSET_SCENE if headset else SCREEN_SCENE
	_packed = load(path) as PackedScene if ResourceLoader.exists(path) else null
	return _packed != null


## Makes the scene anew.
func renew() -> void:
	if scene != null:
		scene.queue_free()
		await scene.tree_exited
		await get_tree().process_frame
	scene = _packed.instantiate()
	_forbid_leaving()
	add_child(scene)
	_forget_visitors()
	_kept = get_sky().panorama
	if CommandLine.of_program().has(FEW_STARS):
		get_sky().magnitude_limit = 4.0
	_listen()
	show_to_visitor(false)
	renewed.emit()


func get_sky() -> BlackHoleSky:
	return scene.get_node("Sky") as BlackHoleSky if scene != null else null


## The headset's session; null at the screen.
func get_session() -> XrSession:
	var xr := scene as XrScene
	return xr.session if xr != null else null


## Gives the scene to the visitor, or takes it away behind the exhibit's own pictures.
func show_to_visitor(shown: bool) -> void:
	var xr := scene as XrScene
	if xr != null:
		# The headset goes on; the window shows the visitor's view, or what calls visitors.
		xr.spectator.set_process(shown)
		if not shown:
			xr.spectator.hide()
			# So that its cameras rest too.
			xr.spectator.mode = xr.spectator.mode
		return
	hold(not shown)
	var display := scene.get_node_or_null(^"Display") as CanvasLayer
	if display != null:
		display.visible = shown
	var camera := scene.get_node_or_null(^"Camera") as Camera3D
	if camera != null and shown:
		camera.make_current()


## The scene on the screen stands still, but for the sky, and hears no key; or goes on.
func hold(held: bool) -> void:
	_is_held = held
	if scene == null or with_headset:
		return
	scene.process_mode = PROCESS_MODE_DISABLED if held else PROCESS_MODE_INHERIT
	get_sky().process_mode = PROCESS_MODE_ALWAYS


## Starts what the visitor chose: VisitDirector.TOUR, or FLIGHT, which needs nothing.
func begin(kind: StringName) -> void:
	if kind == VisitDirector.TOUR:
		for guide in _guides():
			if not tour_file.is_empty():
				guide.tour_file = tour_file
			guide.begin()


## Stops what the visitor chose.
func end() -> void:
	for guide in _guides():
		if guide.is_on():
			guide.leave()
	var xr := scene as XrScene
	if xr != null:
		xr.menu.close()


## The exhibit's pages as a sign before the visitor's eyes; null at the screen.
func put_up_board(config: KioskConfig) -> KioskBoard:
	var xr := scene as XrScene
	if xr == null:
		return null
	var free := config.text("comfort") == "free"
	xr.comfort.preset = Comfort.Preset.FREE if free else Comfort.Preset.COMFORT
	xr.menu.opened.connect(_on_menu_opened)
	var board := KioskBoard.new()
	xr.head.get_parent().add_child(board)
	board.screens.configure(config, true)
	return board


## Where the visitor's head is; at the screen nowhere in particular.
func get_head() -> Transform3D:
	var xr := scene as XrScene
	return xr.head.global_transform if xr != null else Transform3D.IDENTITY


## Puts the view straight.
func recentre() -> void:
	var xr := scene as XrScene
	if xr != null:
		xr.recentre()
	elif scene.has_node(^"Controls"):
		(scene.get_node(^"Controls") as ViewControls).reset()


## How long a picture should take, seconds; 0: unknown.
func get_picture_period() -> float:
	var rate := DisplayServer.screen_get_refresh_rate()
	var session := get_session()
	if session != null and session.get_interface() != null:
		rate = session.get_interface().display_refresh_rate
	return 1.0 / rate if rate > 0.0 else 0.0


func get_comfort() -> Comfort:
	var xr := scene as XrScene
	return xr.comfort if xr != null else null


func _listen() -> void:
	var xr := scene as XrScene
	if xr != null:
		xr.session.lost.connect(lost.emit)
		xr.session.recentred.connect(reset_seen.emit)
	for guide in _guides():
		guide.station_begun.connect(station_begun.emit)
		guide.finished.connect(_on_tour_finished)


func _guides() -> Array[TourGuide]:
	var found: Array[TourGuide] = []
	found.assign(scene.find_children("*", "TourGuide", true, false))
	return found


# Before the scene is there, so that nothing has been shown yet.
func _forbid_leaving() -> void:
	for menu: MainMenu in scene.find_children("*", "MainMenu", true, false):
		menu.can_quit = false
		_hide_buttons(menu)
	for help in scene.find_children("*", "HelpOverlay", true, false):
		_hide_buttons(help)


func _hide_buttons(page: Node) -> void:
	for button: Button in page.find_children("*", "Button", true, false):
		if KEPT_BACK.has(button.name):
			button.visible = false


# The museum's settings are read; what a visitor changes is not written.
func _forget_visitors() -> void:
	for settings: UserSettings in scene.find_children("*", "UserSettings", true, false):
		settings.file = ""


# Before a visit the board is all there is.
func _on_menu_opened() -> void:
	if _is_held:
		(scene as XrScene).menu.close()


# Who has left the tour may go on freely.
func _on_tour_finished(completed: bool) -> void:
	if completed:
		finished.emit()
