# SPDX-License-Identifier: MIT
class_name SkySwitches
extends Node
## What a visitor can switch: the hole, the observer, the background, the images, the exposure.

## A wish that cannot be granted, or a change that nobody asked for.
signal warned(topic: StringName, text: String)

const OBSERVER: StringName = &"observer"
const BACKGROUND: StringName = &"background"
## Seconds in which the hole comes or goes.
const LENSING_SECONDS: float = 2.0
const EXPOSURE_STEP: float = 0.5
const EXPOSURE_LIMIT: float = 8.0
const MOST_ORDERS: int = 4

@export var sky: BlackHoleSky

var _tween: Tween
var _hole_wanted: bool = true


## A static observer needs to be outside the horizon of the hole as it is now. `distance` in
## Schwarzschild radii of the full mass; `mass_fraction` is BlackHoleSky.lensing.
static func can_be_static(distance: float, mass_fraction: float) -> bool:
	return distance > mass_fraction


func is_hole_wanted() -> bool:
	return _hole_wanted


## Lets the hole's mass grow from nothing, or shrink to nothing, before the visitor's eyes.
func toggle_lensing() -> void:
	_hole_wanted = not _hole_wanted
	if _tween != null:
		_tween.kill()
	var target := 1.0 if _hole_wanted else 0.0
	var seconds := LENSING_SECONDS * absf(target - sky.lensing)
	_tween = create_tween().set_trans(Tween.TRANS_SINE).set_ease(Tween.EASE_IN_OUT)
	_tween.tween_property(sky, ^"lensing", target, seconds)


## Changes between static and rain; refuses static at or inside the horizon.
func next_observer(distance: float) -> void:
	if sky.observer_motion == LensingTable.MOTION_STATIC:
		sky.observer_motion = LensingTable.MOTION_RAIN
	elif can_be_static(distance, sky.lensing):
		sky.observer_motion = LensingTable.MOTION_STATIC
	else:
		warned.emit(
			OBSERVER, tr("Nothing can hover at or inside the horizon: you stay in free fall.")
		)


## Turns a static observer who has come to the horizon to rain.
func watch_observer(distance: float) -> void:
	if sky.observer_motion != LensingTable.MOTION_STATIC:
		return
	if can_be_static(distance, sky.lensing):
		return
	sky.observer_motion = LensingTable.MOTION_RAIN
	warned.emit(OBSERVER, tr("Nothing can hover at or inside the horizon: you fall freely now."))


## None, grid, Milky Way, and round again; leaves out a panorama that is not there.
func next_background() -> void:
	match sky.background:
		BlackHoleSky.BACKGROUND_NONE:
			sky.background = BlackHoleSky.BACKGROUND_GRID
		BlackHoleSky.BACKGROUND_GRID when sky.panorama != null:
			sky.background = BlackHoleSky.BACKGROUND_PANORAMA
		BlackHoleSky.BACKGROUND_GRID:
			sky.background = BlackHoleSky.BACKGROUND_NONE
			warned.emit(BACKGROUND, tr("The Milky Way picture is missing."))
		_:
			sky.background = BlackHoleSky.BACKGROUND_NONE


## One image of each star, two, ... four, and one again.
func next_image_orders() -> void:
	sky.image_orders = sky.image_orders % MOST_ORDERS + 1


func change_exposure(steps: int) -> void:
	sky.exposure = clampf(sky.exposure + steps * EXPOSURE_STEP, -EXPOSURE_LIMIT, EXPOSURE_LIMIT)
