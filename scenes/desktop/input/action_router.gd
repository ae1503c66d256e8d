# SPDX-License-Identifier: MIT
class_name ActionRouter
extends Node
## Calls what belongs to an input action when it is pressed.

## Actions that stay alive while `restricted`.
var always: Array[StringName] = []
## True while a menu is open: all other actions are kept back.
var restricted: bool = false

var _calls: Dictionary[StringName, Callable] = {}
var _repeating: Dictionary[StringName, bool] = {}


## Calls `target` at each press of `action`; when `repeats`, also while the key is held.
func route(action: StringName, target: Callable, repeats: bool = false) -> void:
	_calls[action] = target
	_repeating[action] = repeats


func get_actions() -> Array[StringName]:
	return _calls.keys()


func _unhandled_input(event: InputEvent) -> void:
	if event is InputEventMouse or not event.is_pressed():
		return
	for action: StringName in _calls:
		if event.is_action_pressed(action, _repeating[action]):
			if not restricted or always.has(action):
				get_viewport().set_input_as_handled()
				_calls[action].call()
			return
