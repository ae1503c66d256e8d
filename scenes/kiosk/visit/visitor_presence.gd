# SPDX-License-Identifier: MIT
class_name VisitorPresence
extends Node
## Notices visitors: keys, buttons, sticks, the mouse, and a headset that is put on or taken off.
## Must stand after everything else in the scene, so that it hears the input first.

## A sign of life.
signal touched
## A button or key, by somebody who wants to begin.
signal pressed
signal worn_changed(worn: bool)

## From here on a stick is not just trembling.
const STICK: float = 0.4
## Between two looks at the headset, seconds.
const LOOK_SECONDS: float = 0.1

## While true, what wakes the exhibit does nothing else.
var swallows: bool = true

var _presence := HeadsetPresence.new()
var _session: XrSession
var _is_worn: bool = false
var _since_look: float = 0.0


func _input(event: InputEvent) -> void:
	if not _is_sign_of_life(event):
		return
	touched.emit()
	if swallows:
		get_viewport().set_input_as_handled()
		if _is_press(event):
			pressed.emit()


func _process(delta: float) -> void:
	_since_look += delta
	if _session == null or _since_look < LOOK_SECONDS:
		return
	var worn := _presence.see(_session.has_focus(), _session.get_head_pose(), _since_look)
	_since_look = 0.0
	if worn != _is_worn:
		_is_worn = worn
		worn_changed.emit(worn)


## Whose headset is watched from now on; null: none.
func watch(session: XrSession) -> void:
	_session = session


func _is_sign_of_life(event: InputEvent) -> bool:
	if event is InputEventJoypadMotion:
		return absf((event as InputEventJoypadMotion).axis_value) > STICK
	if event is InputEventMouseMotion:
		return (event as InputEventMouseMotion).relative.length_squared() > 4.0
	return event.is_pressed()


func _is_press(event: InputEvent) -> bool:
	var key := event as InputEventKey
	if key != null:
		return not key.echo and not key.ctrl_pressed and not key.alt_pressed
	return (
		event is InputEventMouseButton
		or event is InputEventJoypadButton
		or event is InputEventScreenTouch
	)
