# SPDX-License-Identifier: MIT
class_name ObserverPage
extends VBoxContainer
## Who sees the sky, and how heavy the hole is.

## Masses to choose from, in solar masses.
const MASSES: PackedFloat64Array = [10.0, 4.3e6, 6.5e9]

var sky: BlackHoleSky
var choice: ObserverChoice
var controls: ViewControls

var _observers: Dictionary[ObserverKind.Kind, CheckBox] = {}
var _masses: Array[CheckBox] = []

@onready var _observer_list: VBoxContainer = %ObserverList
@onready var _mass_list: VBoxContainer = %MassList
@onready var _energy: HSlider = %Energy
@onready var _energy_value: Label = %EnergyValue
@onready var _riding: Label = %Riding


func _ready() -> void:
	var group := ButtonGroup.new()
	for kind_name: String in ObserverKind.Kind:
		var kind: ObserverKind.Kind = ObserverKind.Kind[kind_name]
		_observers[kind] = _add_option(_observer_list, group)
		_observers[kind].pressed.connect(_on_observer_pressed.bind(kind))
	group = ButtonGroup.new()
	for mass in MASSES:
		var option := _add_option(_mass_list, group)
		option.pressed.connect(func() -> void: sky.mass_solar = mass)
		_masses.append(option)
	_energy.min_value = ObserverChoice.LEAST_ENERGY
	_energy.max_value = ObserverChoice.LARGEST_ENERGY
	_energy.set_value_no_signal(choice.energy)
	_energy.value_changed.connect(_on_energy_changed)


## What a mass is called.
static func mass_title(mass: float) -> String:
	match mass:
		4.3e6:
			return TranslationServer.translate("Sgr A*: 4.3 million Suns")
		6.5e9:
			return TranslationServer.translate("M87*: 6.5 billion Suns")
	return TranslationServer.translate("10 Suns")


func refresh() -> void:
	var current := choice.get_kind()
	for kind in _observers:
		_observers[kind].text = ObserverKind.title(kind)
		_observers[kind].set_pressed_no_signal(kind == current and not choice.resting)
		_observers[kind].disabled = choice.resting
	_riding.visible = choice.resting
	_energy.editable = not choice.resting
	_energy.set_value_no_signal(choice.energy)
	_energy_value.text = "%.2f" % choice.energy
	for at in MASSES.size():
		_masses[at].text = mass_title(MASSES[at])
		_masses[at].set_pressed_no_signal(is_equal_approx(sky.mass_solar, MASSES[at]))


func _add_option(list: Control, group: ButtonGroup) -> CheckBox:
	var option := CheckBox.new()
	option.button_group = group
	option.auto_translate_mode = Node.AUTO_TRANSLATE_MODE_DISABLED
	list.add_child(option)
	return option


func _on_observer_pressed(kind: ObserverKind.Kind) -> void:
	choice.choose(kind, controls.rig.get_position(), controls.rig.get_orientation() * Vector3.UP)
	refresh()


# Who falls or rises with a chosen energy follows at once.
func _on_energy_changed(value: float) -> void:
	choice.energy = value
	var kind := choice.get_kind()
	if kind == ObserverKind.Kind.FALLING or kind == ObserverKind.Kind.RISING:
		_on_observer_pressed(kind)
	refresh()
