# SPDX-License-Identifier: MIT
class_name ActionRouter
extends Node
## Calls what belongs to an input action when it is pressed.

## Actions that stay alive while `restricted`.
var always: Array[StringName] = []
## True while a menu is open: all other actions are kept back.
var restricted: bool = false
## True while a panel is open that the gamepad goes through: its other actions are kept back, but
## for those in `always_in_panel`.
var gamepad_restricted: bool = false
var always_in_panel: Array[StringName] = []

var _calls: Dictionary[StringName, Callable] = {}
var _repeating: Dictionary[StringName, bool] = {}
var _conditions: Dictionary[StringName, Callable] = {}


## Calls `target` at each press of `action`; when `repeats`, also while the key is held.
func route(action: StringName, target: Callable, repeats: bool = false) -> void:
	_calls[action] = target
	_repeating[action] = repeats


## Calls `target` at each press of `action` while `condition` holds; else the press is for whichever
## action has the same key and was routed later.
func route_while(condition: Callable, action: StringName, target: Callable) -> void:
	route(action, target)
	_conditions[action] = condition


func get_actions() -> Array[StringName]:
	return _calls.keys()


func _unhandled_input(event: InputEvent) -> void:
	if event is InputEventMouseMotion or not event.is_pressed():
		return
	for action: StringName in _calls:
		if event.is_action_pressed(action, _repeating[action]) and _applies(action):
			if not _is_held_back(action, event):
				get_viewport().set_input_as_handled()
				_calls[action].call()
			return


func _applies(action: StringName) -> bool:
	var condition: Callable = _conditions.get(action, Callable())
	return not condition.is_valid() or condition.call() == true


func _is_held_back(action: StringName, event: InputEvent) -> bool:
	if restricted and not always.has(action):
		return true
	var from_pad := event is InputEventJoypadButton or event is InputEventJoypadMotion
	return gamepad_restricted and from_pad and not always_in_panel.has(action)
