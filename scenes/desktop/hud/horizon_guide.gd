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
	watch(controls.rig.get_distance(), controls.mode)


## Gives its advice once for each time the eye goes deep inside while it keeps facing the hole.
func watch(distance: float, mode: ViewControls.Mode) -> void:
	var deep := distance < DEEP
	if deep and not _was_deep and mode == ViewControls.Mode.ORBIT:
		var key := BindingNames.keyboard([&"toggle_flight"])
		var button := BindingNames.gamepad([&"toggle_flight"])
		advised.emit(
			TOPIC,
			tr("The sky is behind you: fly freely (%s or %s) and turn round.") % [key, button]
		)
	_was_deep = deep
