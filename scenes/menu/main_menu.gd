# SPDX-License-Identifier: MIT
class_name MainMenu
extends MenuScreen
## The title with what the program offers; over a visit that has begun, its pause.

signal chosen(item: StringName)

const EXPLORE: StringName = &"explore"
const TOUR: StringName = &"tour"
const EFFECTS: StringName = &"effects"
const PHOTO: StringName = &"photo"
const CARDS: StringName = &"cards"
const SETTINGS: StringName = &"settings"
const CONTROLS: StringName = &"controls"
const CREDITS: StringName = &"credits"
const QUIT: StringName = &"quit"

## Whether a visit goes on behind the menu: it can be gone back to.
var paused: bool = false
## Where nobody may leave the program, as at an exhibit, there is no item for it.
var can_quit: bool = true

var _buttons: Dictionary[StringName, Button] = {}
var _last: StringName = EXPLORE

@onready var _explore: Button = %Explore
@onready var _quit: Button = %Quit
@onready var _version: Label = %Version


func _ready() -> void:
	_buttons = {
		EXPLORE: _explore,
		TOUR: %Tour,
		EFFECTS: %Effects,
		PHOTO: %Photo,
		CARDS: %Cards,
		SETTINGS: %Settings,
		CONTROLS: %Controls,
		CREDITS: %Credits,
		QUIT: _quit,
	}
	for item in _buttons:
		_buttons[item].pressed.connect(_on_pressed.bind(item))
	_version.text = ProgramVersion.text()


## The item that was chosen last; at first the first one.
func get_first_focus() -> Control:
	return _buttons[_last] if _buttons[_last].visible else _explore


func get_items() -> Array[StringName]:
	return _buttons.keys()


func get_button(item: StringName) -> Button:
	return _buttons[item]


## The title cannot be cancelled: there is nothing behind it.
func close() -> void:
	if paused:
		super()


func _on_open() -> void:
	_explore.text = tr("Go on") if paused else tr("Explore")
	_quit.visible = can_quit
	_link()


func _link() -> void:
	var shown: Array[Control] = []
	for button: Button in _buttons.values():
		if button.visible:
			shown.append(button)
	FocusRing.link(shown)


func _on_pressed(item: StringName) -> void:
	_last = EXPLORE if item == QUIT else item
	hide()
	chosen.emit(item)
