# SPDX-License-Identifier: MIT
class_name XrScene
extends Node3D
## The hole as a thing in the visitor's room, seen with a headset; without one the desktop scene.

const DESKTOP_SCENE: String = "res://scenes/desktop/desktop.tscn"
## On the command line, after --: all of the picture is drawn equally finely.
const NO_FOVEATION: String = "--no-foveation"
## So long the screen says that the headset is gone before the program starts again, seconds.
const NOTICE_SECONDS: float = 1.5
## And between two looks whether it is back.
const LOOK_SECONDS: float = 2.5

## The rings to which one can jump are drawn, and can be pointed at.
var rings_shown: bool = false:
	set(value):
		rings_shown = value
		if is_node_ready():
			_show_rings()

## The cards that explain the hole stand beside it.
var cards_shown: bool = false:
	set(value):
		cards_shown = value
		if is_node_ready():
			_show_cards()

var _is_placed: bool = false

@onready var session: XrSession = $Session
@onready var sky: BlackHoleSky = $Sky
@onready var hole: HoleInRoom = $Hole
@onready var head: XRCamera3D = $Headset/Origin/Head
@onready var left_hand: XrHand = $Headset/Origin/LeftHand
@onready var right_hand: XrHand = $Headset/Origin/RightHand
@onready var comfort: Comfort = $Comfort
@onready var rig: XrRig = $Rig
@onready var flight: Flight = $Flight
@onready var jump: RingJump = $Rings
@onready var rides: XrRides = $Rides
@onready var tour: TourGuide = $TourGuide
@onready var pointer: XrPointer = $Headset/Origin/Pointer
@onready var menu: XrMenu = $Headset/Origin/Menu
@onready var menu_layer: PanelLayer = $Headset/Origin/MenuLayer
@onready var cards: HoleCards = $Cards
@onready var spectator: Spectator = $Spectator
@onready var quality: QualityLadder = $Quality
@onready var switches: SkySwitches = $Switches
@onready var _near_limit: NearLimit = $NearLimit
@onready var _brightness: BrightnessLimit = $Brightness
@onready var _pages: VisitPages = $Pages
@onready var _choice: ObserverChoice = $Choice
@onready var _snap_turn: SnapTurn = $SnapTurn
@onready var _smooth_turn: SmoothTurn = $SmoothTurn
@onready var _sign: VisitSign = $Headset/Origin/Sign
@onready var _data: SkyData = $Data
@onready var _screen: ScreenNotice = $Screen


func _enter_tree() -> void:
	if CommandLine.of_program().has(NO_FOVEATION):
		($Session as XrSession).foveated = false
	if StandaloneQuality.is_here():
		StandaloneQuality.apply($Quality, $Session, $Spectator)


func _ready() -> void:
	session.unavailable.connect(_on_unavailable)
	session.lost.connect(_on_lost)
	session.recentred.connect(recentre)
	session.focus_changed.connect(_on_focus_changed)
	comfort.changed.connect(_follow_comfort)
	rides.counted_down.connect(_on_counted_down)
	rides.began.connect(_on_ride_began)
	rides.ended.connect(_on_ride_ended)
	rides.pause_changed.connect(_on_pause_changed)
	sky.horizon_crossed.connect(_on_horizon_crossed)
	_near_limit.crossed.connect(_on_too_near)
	_choice.warned.connect(_on_warned)
	tour.began.connect(_follow_comfort)
	tour.finished.connect(_on_tour_finished)
	tour.caption_changed.connect(_on_tour_caption)
	tour.failed.connect(_sign.say.bind(8.0))
	rig.jumped.connect(_brightness.adapt_at_once)
	for hand: XrHand in [left_hand, right_hand]:
		hand.menu_asked.connect(_on_menu_asked)
	menu.set_pages(_pages.make(), VisitPages.FIRST)
	_follow_comfort()
	_data.load_all()
	if session.start():
		_walk_if_asked()


func _process(_delta: float) -> void:
	# The head's place is known some frames after the first picture.
	if not _is_placed and session.is_shown() and session.get_head_pose() != Transform3D.IDENTITY:
		_place_first()


## Has the runtime gone, so that the screen asks for patience?
func is_waiting_for_headset() -> bool:
	return _screen.visible


## Has the hole been put before the visitor?
func has_started() -> bool:
	return _is_placed


## Ends the program, as the visitor wishes.
func leave() -> void:
	if KioskMode.is_on():
		return
	get_tree().quit()


## Puts the hole anew before the visitor, as at the beginning. A tour or a ride is left first.
func recentre() -> void:
	tour.leave()
	if rides.is_on():
		rides.leave()
		await rides.ended
	_is_placed = true
	rig.set_room(Transform3D.IDENTITY)
	hole.place(session.get_play_area(), session.get_head_pose())


# Whoever asks for a strip of pictures is shown them by a visitor that does not exist.
func _walk_if_asked() -> void:
	var folder := VisitStrip.folder_from(CommandLine.of_program())
	if folder.is_empty():
		return
	var strip := VisitStrip.new()
	strip.scene = self
	add_child(strip)
	strip.walk(folder)


func _place_first() -> void:
	var room: Variant = VisitMemory.recall(sky) if Supervision.is_started_again() else null
	if room == null:
		recentre()
	else:
		_is_placed = true
		rig.set_room(room)
		print("xr: back at the same place")


func _follow_comfort() -> void:
	_show_cards()
	_snap_turn.enabled = not comfort.smooth_turn and not _is_carried()
	_smooth_turn.enabled = comfort.smooth_turn and not _is_carried()
	flight.enabled = comfort.smooth_flight and not _is_carried()
	sky.stereo_baseline_scale = comfort.stereo_baseline
	_show_rings()


# On rides there is no reading, and a tour has its own words.
func _show_cards() -> void:
	cards.visible = cards_shown and not _is_carried()


func _show_rings() -> void:
	jump.enabled = rings_shown and not _is_carried()


func _is_carried() -> bool:
	return rides.is_on() or tour.is_on()


func _on_menu_asked() -> void:
	menu.toggle(head.global_transform)


func _on_warned(_topic: StringName, text: String) -> void:
	_sign.say(text, 5.0)


func _on_too_near(too_near: bool) -> void:
	if too_near:
		_sign.say(
			tr("Nobody can rest so near the horizon. Step back, or take the ride that falls in.")
		)
	elif not rides.is_on():
		_sign.clear()


func _on_counted_down(seconds: int) -> void:
	_follow_comfort()
	if seconds > 0:
		_sign.say(str(seconds), 1.2)


func _on_ride_began() -> void:
	_sign.clear()
	_follow_comfort()


# By the visitor; the spectators' camera passes it as well.
func _on_horizon_crossed(inward: bool, camera: Camera3D) -> void:
	if inward and rides.is_on() and camera is XRCamera3D:
		_sign.say(tr("That was the horizon. Look round: the sky is behind you now."), 6.0)


func _on_ride_ended(completed: bool) -> void:
	_sign.clear()
	_follow_comfort()
	if completed:
		_sign.say(
			tr("You have fallen through the horizon. Nobody has ever come back to tell."), 7.0
		)


func _on_pause_changed(paused: bool) -> void:
	if paused:
		_sign.say(tr("Paused"))
	else:
		_sign.clear()


# Those who stand around read along.
func _on_tour_caption(text: String) -> void:
	if not text.is_empty():
		spectator.set_caption(tr(text))


func _on_tour_finished(_completed: bool) -> void:
	_follow_comfort()
	spectator.set_caption(($Echo as VisitEcho).caption())


func _on_unavailable(reason: String) -> void:
	if Supervision.is_supervised() and Supervision.is_started_again():
		_wait_for_headset(Supervision.STILL_WAITING, LOOK_SECONDS)
		return
	push_warning("XR: %s The desktop scene is shown instead." % reason)
	get_tree().change_scene_to_file.call_deferred(DESKTOP_SCENE)


func _on_lost() -> void:
	tour.leave()
	if _is_placed:
		VisitMemory.store(rides.get_home_radius(), sky.global_position, rides.get_home())
	_wait_for_headset(Supervision.LOST, NOTICE_SECONDS)


func _on_focus_changed(focused: bool) -> void:
	print("xr: %s" % ("in focus" if focused else "out of focus"))
	pointer.enabled = focused
	if not focused:
		rides.set_paused(true)
		tour.set_paused(true)


func _wait_for_headset(status: int, seconds: float) -> void:
	if not Supervision.is_supervised():
		_screen.show_text(tr("The headset is not connected. Start the program again to find it."))
		return
	_screen.show_text(tr("The headset is not connected. The exhibit goes on when it is back."))
	await get_tree().create_timer(seconds).timeout
	# Tests have the scene in a tree that is not its own.
	if get_tree().current_scene == self:
		get_tree().quit(status)
