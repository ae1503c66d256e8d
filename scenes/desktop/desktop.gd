# SPDX-License-Identifier: MIT
class_name DesktopScene
extends Node3D
## A black hole and the sky behind it, for a screen: joins data, controls, switches and display.

@onready var _data: SkyData = $Data
@onready var _switches: SkySwitches = $Switches
@onready var _overlays: SkyOverlays = $Overlays
@onready var _disk: DiskSwitches = $DiskSwitches
@onready var _controls: ViewControls = $Controls
@onready var _choice: ObserverChoice = $Choice
@onready var _rides: RideDirector = $Rides
@onready var _router: ActionRouter = $Actions
@onready var _readouts: Readouts = %Readouts
@onready var _map: MapWindow = %Map
@onready var _ride_bar: RideBar = %RideBar
@onready var _panel: SkyPanel = %Panel
@onready var _hint: Label = %Hint
@onready var _pointer: IdlePointer = $IdlePointer
@onready var _frame: Control = %Frame
@onready var _notices: NoticeBoard = %Notices
@onready var _guide: HorizonGuide = $HorizonGuide
@onready var _help: HelpOverlay = %Help


func _ready() -> void:
	if SelfTestScene.is_asked_for(OS.get_cmdline_user_args()):
		get_tree().change_scene_to_file.call_deferred(SelfTestScene.FILE)
		return
	_data.warned.connect(_on_data_warned)
	_data.settled.connect(_notices.take_down)
	_switches.warned.connect(_on_advised)
	_overlays.warned.connect(_on_data_warned)
	_choice.warned.connect(_on_advised)
	_rides.warned.connect(_on_advised)
	_guide.advised.connect(_on_advised)
	_help.visibility_changed.connect(_on_help_visibility_changed)
	_panel.visibility_changed.connect(_on_panel_visibility_changed)
	_rides.started.connect(_make_room)
	_rides.left.connect(_make_room)
	_help.fullscreen_asked.connect(toggle_fullscreen)
	_help.quit_asked.connect(quit)
	_route_actions()
	_data.load_all()
	_show_hint()


func _notification(what: int) -> void:
	if what == NOTIFICATION_TRANSLATION_CHANGED and is_node_ready():
		_show_hint()


func _process(_delta: float) -> void:
	_choice.watch(_controls.rig.get_position())


func toggle_hud() -> void:
	_readouts.visible = not _readouts.visible
	_make_room()


func toggle_help() -> void:
	if _help.visible:
		_help.close()
	else:
		_help.open()


func toggle_fullscreen() -> void:
	var window := get_window()
	var full := window.mode == Window.MODE_FULLSCREEN
	window.mode = Window.MODE_WINDOWED if full else Window.MODE_FULLSCREEN


func quit() -> void:
	get_tree().quit()


func _route_actions() -> void:
	_route_ride_actions()
	_router.route(&"toggle_panel", _panel.toggle)
	_router.route(&"toggle_lensing", _on_toggle_lensing)
	_router.route(&"next_observer", _on_next_observer)
	_router.route(&"toggle_map", _map.toggle)
	_router.route(&"toggle_names", _overlays.toggle_names)
	_router.route(&"toggle_overlays", _overlays.toggle_of_hole)
	_router.route(&"toggle_disk", _disk.toggle)
	_router.route(&"next_disk", _disk.next_preset)
	_router.route(&"next_background", _switches.next_background)
	_router.route(&"next_image_orders", _switches.next_image_orders)
	_router.route(&"exposure_up", _switches.change_exposure.bind(1), true)
	_router.route(&"exposure_down", _switches.change_exposure.bind(-1), true)
	_router.route(&"toggle_flight", _controls.toggle_mode)
	_router.route(&"reset_view", _on_reset_view)
	_router.route(&"toggle_hud", toggle_hud)
	_router.route(&"toggle_help", toggle_help)
	_router.route(&"toggle_fullscreen", toggle_fullscreen)
	_router.route(&"quit", _help.ask_to_quit)
	_router.always = [&"toggle_help", &"toggle_fullscreen", &"quit"]
	_router.always_in_panel = [&"toggle_panel", &"toggle_help"]


# First, as they share buttons of the gamepad with what cannot be done on a ride.
func _route_ride_actions() -> void:
	_router.route_while(_rides.is_on, &"ride_pause", _rides.toggle_pause)
	_router.route_while(_rides.is_on, &"ride_reverse", _rides.reverse)
	_router.route_while(_rides.is_on, &"ride_slower", _rides.change_pace.bind(-1))
	_router.route_while(_rides.is_on, &"ride_faster", _rides.change_pace.bind(1))
	_router.route_while(_rides.is_on, &"ride_leave", _rides.leave)


func _show_hint() -> void:
	var keys := BindingNames.keyboard([&"toggle_help"])
	_hint.text = "%s  %s" % [keys.get_slice(BindingNames.BETWEEN, 0), tr("Help")]


func _on_next_observer() -> void:
	if _is_free_to_choose():
		var up := _controls.rig.get_orientation() * Vector3.UP
		_choice.choose_next(_controls.rig.get_position(), up)


func _on_toggle_lensing() -> void:
	if _is_free_to_choose():
		_switches.toggle_lensing()


func _on_reset_view() -> void:
	_rides.leave()
	_controls.reset()


# On a ride the motion and the hole are the ride's.
func _is_free_to_choose() -> bool:
	if _rides.is_on():
		var key := BindingNames.keyboard([&"ride_leave"])
		var button := BindingNames.gamepad([&"ride_leave"])
		_on_advised(RideDirector.TOPIC, tr("Leave the ride first (%s or %s).") % [key, button])
	return not _rides.is_on()


func _on_data_warned(topic: StringName, text: String) -> void:
	var stays_up := topic == SkyData.TABLE and _data.is_computing()
	_notices.post(topic, text, 0.0 if stays_up else 2.0 * NoticeBoard.SHOWN_SECONDS)


func _on_advised(topic: StringName, text: String) -> void:
	_notices.post(topic, text)


func _on_help_visibility_changed() -> void:
	_controls.listening = not _help.visible
	_router.restricted = _help.visible
	_frame.visible = not _help.visible
	_pointer.wake()


# The bar of a ride names its keys itself and takes the place of the hint.
func _make_room() -> void:
	_hint.visible = _readouts.visible and not _rides.is_on()
	_ride_bar.modulate.a = 1.0 if _readouts.visible else 0.0


func _on_panel_visibility_changed() -> void:
	_controls.keys_listening = not _panel.visible
	_router.gamepad_restricted = _panel.visible
	_pointer.wake()
