# SPDX-License-Identifier: MIT
class_name SkySwitches
extends Node
## What a visitor can switch: the hole, the background, the images, the exposure.

## A wish that cannot be granted, or a change that nobody asked for.
signal warned(topic: StringName, text: String)

const BACKGROUND: StringName = &"background"
## Seconds in which the hole comes or goes.
const LENSING_SECONDS: float = 2.0
const EXPOSURE_STEP: float = 0.5
const EXPOSURE_LIMIT: float = 8.0
const MOST_ORDERS: int = 4

@export var sky: BlackHoleSky
## The hole grows and shrinks before the visitor's eyes; else it comes and goes at once.
@export var gradual: bool = true

var _tween: Tween
var _hole_wanted: bool = true


func is_hole_wanted() -> bool:
	return _hole_wanted


## Lets the hole's mass grow from nothing, or shrink to nothing, before the visitor's eyes.
func toggle_lensing() -> void:
	want_hole(not _hole_wanted)


## Lets the hole come or go, if it is not so already.
func want_hole(wanted: bool) -> void:
	if wanted == _hole_wanted:
		return
	_hole_wanted = wanted
	if _tween != null:
		_tween.kill()
	var target := 1.0 if _hole_wanted else 0.0
	if not gradual:
		sky.lensing = target
		return
	var seconds := LENSING_SECONDS * absf(target - sky.lensing)
	_tween = create_tween().set_trans(Tween.TRANS_SINE).set_ease(Tween.EASE_IN_OUT)
	_tween.tween_property(sky, ^"lensing", target, seconds)


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
