# SPDX-License-Identifier: MIT
class_name Comfort
extends Node
## What makes a visit comfortable, in one place: two presets and what they consist of. Whoever moves
## the visitor asks here how.

## A setting has changed, by itself or with a preset.
signal changed

enum Preset {
	## For everyone and for long: jumps and blinks instead of gliding.
	COMFORT,
	## For those who know that gliding does not make them sick.
	FREE,
}
enum Hands { BOTH, LEFT, RIGHT }

## Names what a preset sets, and to which value.
const VALUES: Dictionary[Preset, Dictionary] = {
	Preset.COMFORT:
	{
		"smooth_turn": false,
		"smooth_flight": false,
		"blinks": true,
		"vignette": 0.7,
		"fixed_frame": true,
		"stereo_baseline": 0.1,
	},
	Preset.FREE:
	{
		"smooth_turn": true,
		"smooth_flight": true,
		"blinks": true,
		"vignette": 0.0,
		"fixed_frame": false,
		"stereo_baseline": 0.25,
	},
}

@export var preset: Preset = Preset.COMFORT:
	set(value):
		preset = value
		for property: String in VALUES[preset]:
			set(property, VALUES[preset][property])
## Turning by the stick glides, or goes in steps.
@export var smooth_turn: bool = false:
	set = _set_smooth_turn
## The stick flies, or only jumps lead from place to place.
@export var smooth_flight: bool = false:
	set = _set_smooth_flight
## The picture goes black for a moment when the place changes at once.
@export var blinks: bool = true:
	set = _set_blinks
## How far the field of view closes in while the visitor is moved, 0 to 1.
@export_range(0.0, 1.0) var vignette: float = 0.7:
	set = _set_vignette
## A faint grid that stays with the room while the visitor is moved.
@export var fixed_frame: bool = true:
	set = _set_fixed_frame
## How far apart the eyes are for the bending of light, in parts of the truth.
@export_range(0.0, 1.0) var stereo_baseline: float = 0.1:
	set = _set_stereo_baseline
## Which hands count; one alone can do everything.
@export var hands: Hands = Hands.BOTH:
	set = _set_hands


## Does this hand (true: the left one) count?
func counts(left: bool) -> bool:
	return hands == Hands.BOTH or (hands == Hands.LEFT) == left


func _set_smooth_turn(value: bool) -> void:
	smooth_turn = value
	changed.emit()


func _set_smooth_flight(value: bool) -> void:
	smooth_flight = value
	changed.emit()


func _set_blinks(value: bool) -> void:
	blinks = value
	changed.emit()


func _set_vignette(value: float) -> void:
	vignette = clampf(value, 0.0, 1.0)
	changed.emit()


func _set_fixed_frame(value: bool) -> void:
	fixed_frame = value
	changed.emit()


func _set_stereo_baseline(value: float) -> void:
	stereo_baseline = clampf(value, 0.0, 1.0)
	changed.emit()


func _set_hands(value: Hands) -> void:
	hands = value
	changed.emit()
