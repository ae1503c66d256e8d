# SPDX-License-Identifier: MIT
class_name RidesPage
extends VBoxContainer
## The rides, to be started.

## A ride has begun.
signal chosen

var director: RideDirector

var _buttons: Dictionary[RideDirector.Kind, Button] = {}

@onready var _list: VBoxContainer = %RideList
@onready var _leave: Button = %LeaveRide


func _ready() -> void:
	for kind_name: String in RideDirector.Kind:
		var kind: RideDirector.Kind = RideDirector.Kind[kind_name]
		var button := Button.new()
		button.alignment = HORIZONTAL_ALIGNMENT_LEFT
		button.theme_type_variation = &"SmallButton"
		button.auto_translate_mode = Node.AUTO_TRANSLATE_MODE_DISABLED
		button.pressed.connect(_on_pressed.bind(kind))
		_list.add_child(button)
		_buttons[kind] = button
	_leave.pressed.connect(director.leave)


func refresh() -> void:
	for kind in _buttons:
		_buttons[kind].text = RideDirector.title(kind)
	_leave.disabled = not director.is_on()


func _on_pressed(kind: RideDirector.Kind) -> void:
	if director.start(kind):
		chosen.emit()
