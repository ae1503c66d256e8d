# SPDX-License-Identifier: MIT
class_name HorizonGuide
extends Node
## Tells a visitor who has gone deep inside the horizon, and sees only the shadow ahead, where the
## sky is.

signal advised(topic: StringName, text: String)

const TOPIC: StringName = &"inside"
## The shadow fills the picture below this distance, in Schwarzschild radii.
const DEEP: float = 0.6

@export var controls: ViewControls

var _was_deep: bool = false


func _process(_delta: float) -> void:
	watch(controls.rig.get_distance(), controls.mode, controls.gaze)


## Gives its advice once for each time the eye goes deep inside while it keeps facing the hole.
func watch(
	distance: float, mode: ViewControls.Mode, gaze: ViewControls.Gaze = ViewControls.Gaze.FREE
) -> void:
	var deep := distance < DEEP
	if deep and not _was_deep:
		var key := BindingNames.keyboard([&"toggle_flight"])
		var button := BindingNames.gamepad([&"toggle_flight"])
		if mode == ViewControls.Mode.ORBIT:
			var text := tr("The sky is behind you: fly freely (%s or %s) and turn round.")
			advised.emit(TOPIC, text % [key, button])
		elif mode == ViewControls.Mode.RIDE and gaze != ViewControls.Gaze.AWAY:
			var text := tr("The sky is behind you: look back (%s or %s) or turn round.")
			advised.emit(TOPIC, text % [key, button])
	_was_deep = deep
