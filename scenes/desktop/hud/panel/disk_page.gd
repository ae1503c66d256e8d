# SPDX-License-Identifier: MIT
class_name DiskPage
extends VBoxContainer
## The accretion disk: whether it is there, what is shown of it, how it lies, how it glows and how
## fast it turns.

var switches: DiskSwitches
var clock: DiskClock

@onready var _shown: CheckBox = %Shown
@onready var _preset: Stepper = %Preset
@onready var _look: Stepper = %Look
@onready var _orders: Stepper = %DiskOrders
@onready var _inclination: ValueSlider = %Inclination
@onready var _outer_radius: ValueSlider = %OuterRadius
@onready var _temperature: ValueSlider = %Temperature
@onready var _brightness: ValueSlider = %Brightness
@onready var _opacity: ValueSlider = %Opacity
@onready var _time: ValueSlider = %TimeLapse
@onready var _plunging: CheckBox = %Plunging
@onready var _retrograde: CheckBox = %Retrograde


func _ready() -> void:
	var disk := switches.disk
	_shown.toggled.connect(func(on: bool) -> void: disk.visible = on)
	_preset.chosen.connect(func(at: int) -> void: switches.preset = DiskPresets.NAMES[at])
	_look.chosen.connect(func(at: int) -> void: disk.look = at as AccretionDisk.Look)
	_orders.chosen.connect(func(at: int) -> void: disk.orders = at + 1)
	_inclination.value_changed.connect(func(to: float) -> void: switches.inclination = to)
	_outer_radius.value_changed.connect(func(to: float) -> void: disk.outer_radius = to)
	_temperature.value_changed.connect(func(to: float) -> void: disk.peak_temperature = to)
	_brightness.value_changed.connect(func(to: float) -> void: disk.brightness_ev = to)
	_opacity.value_changed.connect(func(to: float) -> void: disk.opacity = to)
	_time.value_changed.connect(func(to: float) -> void: clock.rate = to)
	_plunging.toggled.connect(func(on: bool) -> void: disk.plunging_gas = on)
	_retrograde.toggled.connect(func(on: bool) -> void: disk.retrograde = on)


func refresh() -> void:
	var disk := switches.disk
	_shown.set_pressed_no_signal(disk.visible)
	_preset.titles = preset_titles()
	_preset.at = DiskPresets.NAMES.find(switches.preset)
	_look.titles = look_titles()
	_look.at = disk.look
	_orders.titles = ["1", "2", "3", "4"]
	_orders.at = disk.orders - 1
	_inclination.display(switches.inclination, "%d°" % roundi(switches.inclination))
	_outer_radius.display(disk.outer_radius, "%.1f rₛ" % disk.outer_radius)
	_temperature.display(disk.peak_temperature, "%d K" % roundi(disk.peak_temperature))
	_brightness.display(disk.brightness_ev, ReadoutText.exposure(disk.brightness_ev))
	_opacity.display(disk.opacity, "%.2f" % disk.opacity)
	_time.editable = not clock.is_on_ride()
	_time.display(clock.rate, "%d rₛ/c" % roundi(clock.rate) if _time.editable else tr("ride's"))
	_plunging.set_pressed_no_signal(disk.plunging_gas)
	_retrograde.set_pressed_no_signal(disk.retrograde)


## In the order of [constant DiskPresets.NAMES].
static func preset_titles() -> PackedStringArray:
	return [_translated("Museum"), _translated("Physicist"), _translated("Film")]


## In the order of [enum AccretionDisk.Look].
static func look_titles() -> PackedStringArray:
	return [
		_translated("Smooth glow"),
		_translated("Turbulent glow"),
		_translated("Checkerboard"),
		_translated("Temperature"),
		_translated("Frequency shift"),
		_translated("Rings"),
	]


static func _translated(text: String) -> String:
	return TranslationServer.translate(text)
