# SPDX-License-Identifier: MIT
class_name ExhibitScreens
extends CanvasLayer
## Every page of the exhibit, visitors' and operator's, by name, over whatever sky is behind.

const SCREENS: PackedScene = preload("res://scenes/kiosk/screens/kiosk_screens.tscn")
const PIN_PAD: PackedScene = preload("res://scenes/kiosk/operator/pin_pad.tscn")
const PANEL: PackedScene = preload("res://scenes/kiosk/operator/operator_panel.tscn")
const THEME: Theme = preload("res://scenes/desktop/hud/hud_theme.tres")

## What the operator may read on a usual day, by the panel's titles.
const FACTS: Dictionary[String, String] = {
	"State": "12:34",
	"Headset": "Monado",
	"Renderer": "mobile",
	"Graphics card": "NVIDIA GeForce RTX 4090",
	"Pictures per second": "90",
	"Late pictures": "3",
	"Visits today": "147",
	"Running for": "7:45 h",
	"Version": "1.2.3",
	"Settings": "/opt/blackhole_sky/kiosk.json",
	"Wrong settings": "0",
	"Logs": "/var/log/blackhole_sky",
	"Log trouble": "–",
}

var _screens: KioskScreens = SCREENS.instantiate()
var _pad: PinPad = PIN_PAD.instantiate()
var _panel: OperatorPanel = PANEL.instantiate()
var _shows: Dictionary[String, Callable] = {}


func _init() -> void:
	layer = 60
	_pad.theme = THEME
	_panel.theme = THEME
	for page: Control in [_screens, _pad, _panel]:
		add_child(page)
	_panel.facts = func() -> Dictionary: return FACTS
	_panel.errors = func() -> PackedStringArray: return PackedStringArray()
	for state: VisitDirector.State in VisitDirector.State.values():
		if state != VisitDirector.State.VISIT:
			var step: String = VisitDirector.State.keys()[state]
			_shows["exhibit_" + step.to_lower()] = _show_state.bind(state)
	_shows["exhibit_pin"] = _pad.open
	_shows["exhibit_operator"] = _show_operator


func get_names() -> PackedStringArray:
	return PackedStringArray(_shows.keys())


## Opens the page of a name.
func show_page(page: String) -> void:
	_shows[page].call()


## Closes whatever is open.
func clear() -> void:
	_screens.show_state(VisitDirector.State.VISIT)
	_pad.close()
	_panel.close()


func _show_state(state: VisitDirector.State) -> void:
	_screens.configure(KioskConfig.from_data({}), false)
	_screens.show_state(state)


func _show_operator() -> void:
	_panel.offer(PackedStringArray(["en", "de"]), TranslationServer.get_locale(), 0.8, null)
	_panel.open()
