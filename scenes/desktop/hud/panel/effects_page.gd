# SPDX-License-Identifier: MIT
class_name EffectsPage
extends VBoxContainer
## Switches for each effect of the light's way, the redshift map, the stars and the adapting
## exposure, and how strong colours are.

var sky: BlackHoleSky

var _inside: bool = false

@onready var _deflection: CheckBox = %Deflection
@onready var _aberration: CheckBox = %Aberration
@onready var _gravitational: CheckBox = %Gravitational
@onready var _doppler: CheckBox = %Doppler
@onready var _magnification: CheckBox = %Magnification
@onready var _higher_orders: CheckBox = %HigherOrders
@onready var _reason: Label = %Reason
@onready var _redshift_map: CheckBox = %RedshiftMap
@onready var _stars: CheckBox = %Stars
@onready var _adapting: CheckBox = %Adapting
@onready var _saturation: HSlider = %Saturation
@onready var _saturation_value: Label = %SaturationValue


func _ready() -> void:
	_deflection.toggled.connect(_on_deflection_toggled)
	_aberration.toggled.connect(func(on: bool) -> void: sky.effect_aberration = on)
	_gravitational.toggled.connect(_on_gravitational_toggled)
	_doppler.toggled.connect(func(on: bool) -> void: sky.effect_doppler = on)
	_magnification.toggled.connect(func(on: bool) -> void: sky.effect_magnification = on)
	_higher_orders.toggled.connect(func(on: bool) -> void: sky.effect_higher_orders = on)
	_redshift_map.toggled.connect(func(on: bool) -> void: sky.redshift_map = on)
	_stars.toggled.connect(func(on: bool) -> void: sky.stars_visible = on)
	_adapting.toggled.connect(func(on: bool) -> void: sky.auto_exposure = on)
	_saturation.value_changed.connect(func(value: float) -> void: sky.saturation = value)


## Shows what is on. At and inside the horizon, `inside`, only pairs of effects can be switched.
func refresh(inside: bool) -> void:
	_inside = inside
	var pair := sky.effect_deflection or sky.effect_aberration
	var shift_pair := sky.effect_gravitational_shift or sky.effect_doppler
	_deflection.text = tr("Deflection and aberration") if inside else tr("Deflection")
	_gravitational.text = tr("Frequency shift, all of it") if inside else tr("Gravitational shift")
	_deflection.set_pressed_no_signal(pair if inside else sky.effect_deflection)
	_aberration.set_pressed_no_signal(sky.effect_aberration)
	_gravitational.set_pressed_no_signal(shift_pair if inside else sky.effect_gravitational_shift)
	_doppler.set_pressed_no_signal(sky.effect_doppler)
	_aberration.visible = not inside
	_doppler.visible = not inside
	_reason.visible = inside
	_magnification.set_pressed_no_signal(sky.effect_magnification)
	_higher_orders.set_pressed_no_signal(sky.effect_higher_orders)
	_redshift_map.set_pressed_no_signal(sky.redshift_map)
	_stars.set_pressed_no_signal(sky.stars_visible)
	_adapting.set_pressed_no_signal(sky.auto_exposure)
	_saturation.set_value_no_signal(sky.saturation)
	_saturation_value.text = "%.2f" % sky.saturation


func _on_deflection_toggled(on: bool) -> void:
	sky.effect_deflection = on
	if _inside:
		sky.effect_aberration = on


func _on_gravitational_toggled(on: bool) -> void:
	sky.effect_gravitational_shift = on
	if _inside:
		sky.effect_doppler = on
