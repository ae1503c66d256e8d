# SPDX-License-Identifier: MIT
class_name DesktopScene
extends Node3D
## A black hole and the sky behind it, for a screen: joins data, controls, switches and display.

@onready var _data: SkyData = $Data
@onready var _switches: SkySwitches = $Switches
@onready var _controls: ViewControls = $Controls
@onready var _router: ActionRouter = $Actions
@onready var _readouts: Readouts = %Readouts
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
	_guide.advised.connect(_on_advised)
	_help.visibility_changed.connect(_on_help_visibility_changed)
	_help.fullscreen_asked.connect(toggle_fullscreen)
	_help.quit_asked.connect(quit)
	_route_actions()
	_data.load_all()
	_show_hint()


func _notification(what: int) -> void:
	if what == NOTIFICATION_TRANSLATION_CHANGED and is_node_ready():
		_show_hint()


func _process(_delta: float) -> void:
	_switches.watch_observer(_controls.rig.get_distance())


func toggle_hud() -> void:
	_readouts.visible = not _readouts.visible
	_hint.visible = _readouts.visible


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
	_router.route(&"toggle_lensing", _switches.toggle_lensing)
	_router.route(&"next_observer", _on_next_observer)
	_router.route(&"next_background", _switches.next_background)
	_router.route(&"next_image_orders", _switches.next_image_orders)
	_router.route(&"exposure_up", _switches.change_exposure.bind(1), true)
	_router.route(&"exposure_down", _switches.change_exposure.bind(-1), true)
	_router.route(&"toggle_flight", _controls.toggle_mode)
	_router.route(&"reset_view", _controls.reset)
	_router.route(&"toggle_hud", toggle_hud)
	_router.route(&"toggle_help", toggle_help)
	_router.route(&"toggle_fullscreen", toggle_fullscreen)
	_router.route(&"quit", _help.ask_to_quit)
	_router.always = [&"toggle_help", &"toggle_fullscreen", &"quit"]


func _show_hint() -> void:
	var keys := BindingNames.keyboard([&"toggle_help"])
	_hint.text = "%s  %s" % [keys.get_slice(BindingNames.BETWEEN, 0), tr("Help")]


func _on_next_observer() -> void:
	_switches.next_observer(_controls.rig.get_distance())


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
