# SPDX-License-Identifier: MIT
class_name DesktopScene
extends Node3D
## A black hole and the sky behind it, for a screen: joins data, controls, switches and display.

## Frames after which the first picture is whole.
const SETTLING_FRAMES: int = 3

var _first_frame: int = 0

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
@onready var _notices: NoticeBoard = %Notices
@onready var _guide: HorizonGuide = $HorizonGuide
@onready var _help: HelpOverlay = %Help
@onready var _menus: MenuDirector = $Menus
@onready var _photo: PhotoMode = %PhotoMode
@onready var _tour: TourGuide = %TourGuide
@onready var _settings: UserSettings = $UserSettings
@onready var _sky: BlackHoleSky = $Sky


func _ready() -> void:
	_data.warned.connect(_on_data_warned)
	_data.settled.connect(_notices.take_down)
	_switches.warned.connect(_on_advised)
	_overlays.warned.connect(_on_data_warned)
	_choice.warned.connect(_on_advised)
	_rides.warned.connect(_on_advised)
	_guide.advised.connect(_on_advised)
	_rides.started.connect(_make_room)
	_rides.left.connect(_make_room)
	_help.fullscreen_asked.connect(toggle_fullscreen)
	_menus.quit_asked.connect(quit)
	_menus.photo_asked.connect(_photo.open)
	_menus.tour_asked.connect(_tour.begin)
	_tour.failed.connect(func(reason: String) -> void: _on_advised(&"tour", reason))
	_tour.finished.connect(_on_tour_finished)
	_route_actions()
	_data.load_all()
	_show_hint()
	if not _settings.faults.is_empty():
		_on_data_warned(&"settings", "\n".join(_settings.faults))
	_first_frame = Engine.get_frames_drawn() + SETTLING_FRAMES


func _notification(what: int) -> void:
	if what == NOTIFICATION_TRANSLATION_CHANGED and is_node_ready():
		_show_hint()


func _process(_delta: float) -> void:
	_choice.watch(_controls.rig.get_position())


func toggle_hud() -> void:
	_readouts.visible = not _readouts.visible
	_make_room()


## Opens the program's title over the sky.
func show_title() -> void:
	_menus.show_title()


## Whether the picture is the one that will stay: the hole is there.
func is_sky_ready() -> bool:
	return _sky.table != null and _sky.table.is_ready() and Engine.get_frames_drawn() > _first_frame


## The setting is kept, whatever the command line asked for.
func toggle_fullscreen() -> void:
	if KioskMode.is_on():
		return
	var full := get_window().mode == Window.MODE_FULLSCREEN
	get_window().mode = Window.MODE_WINDOWED if full else Window.MODE_FULLSCREEN
	_settings.set_value(&"fullscreen", not full)


## Not for an exhibit's visitors.
func quit() -> void:
	if KioskMode.is_on():
		return
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
	_router.route(&"toggle_help", _menus.toggle_page.bind(MainMenu.CONTROLS))
	_router.route(&"toggle_fullscreen", toggle_fullscreen)
	_router.route(&"toggle_menu", _menus.toggle_menu)
	_router.always = [&"toggle_help", &"toggle_fullscreen", &"toggle_menu"]
	_router.always_in_panel = [&"toggle_panel", &"toggle_help", &"toggle_menu"]


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


func _on_tour_finished(completed: bool) -> void:
	if completed:
		_menus.toggle_menu()


# The bar of a ride names its keys itself and takes the place of the hint.
func _make_room() -> void:
	_hint.visible = _readouts.visible and not _rides.is_on()
	_ride_bar.modulate.a = 1.0 if _readouts.visible else 0.0
