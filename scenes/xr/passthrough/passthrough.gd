# SPDX-License-Identifier: MIT
class_name Passthrough
extends Node
## Shows the visitor's own room round the hole, where the headset can: the sky is clear where light
## goes straight, and the hole hangs in the room with its ring of bent stars.

## The room is shown from now on, or no longer.
signal changed(on: bool)

const CLEAR := Color(0.0, 0.0, 0.0, 0.0)

@export var session: XrSession
## What the headset shows.
@export var viewport: SubViewport
@export var sky: BlackHoleSky
## How clear the sky is where light goes straight: 1 shows the room alone there, 0 the sky.
@export_range(0.0, 1.0, 0.05) var clearness: float = 1.0

var _on: bool = false
## Of the world, before the room was shown.
var _background_mode := Environment.BG_COLOR
var _background_colour := Color.BLACK


func _ready() -> void:
	session.lost.connect(_on_session_gone)


func _exit_tree() -> void:
	_show_room(false)


## Can this headset show the room behind the picture?
func is_offered() -> bool:
	return why_not().is_empty()


## Why it cannot, for people; empty when it can.
func why_not() -> String:
	var interface := session.get_interface()
	if interface == null or not session.is_shown():
		return tr("No headset shows a picture yet.")
	return reason_of(interface.get_supported_environment_blend_modes())


## The same for a headset that offers these ways (XRInterface.EnvironmentBlendMode) to lay a picture
## over the room.
func reason_of(blend_modes: Array) -> String:
	if blend_modes.has(XRInterface.XR_ENV_BLEND_MODE_ALPHA_BLEND):
		return ""
	return tr("This headset, or its runtime, does not show the room behind the picture.")


## Is the room shown?
func is_on() -> bool:
	return _on


## Shows the room, or the whole sky again. False when the headset refused, and nothing has changed.
func set_on(on: bool) -> bool:
	if on == _on:
		return true
	if on and not is_offered():
		return false
	var mode := (
		XRInterface.XR_ENV_BLEND_MODE_ALPHA_BLEND if on else XRInterface.XR_ENV_BLEND_MODE_OPAQUE
	)
	var interface := session.get_interface()
	if interface != null and not interface.set_environment_blend_mode(mode) and on:
		return false
	_show_room(on)
	return true


# The picture's part of it: what is clear in it, and what stands behind.
func _show_room(on: bool) -> void:
	if on == _on:
		return
	_on = on
	viewport.transparent_bg = on
	sky.see_through = clearness if on else 0.0
	var world := viewport.find_world_3d()
	var environment := world.environment if world != null else null
	if environment != null:
		if on:
			_background_mode = environment.background_mode
			_background_colour = environment.background_color
		environment.background_mode = Environment.BG_COLOR if on else _background_mode
		environment.background_color = CLEAR if on else _background_colour
	changed.emit(on)


func _on_session_gone() -> void:
	_show_room(false)
