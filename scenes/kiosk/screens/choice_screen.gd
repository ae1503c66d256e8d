# SPDX-License-Identifier: MIT
class_name ChoiceScreen
extends MenuScreen
## The visitor chooses between the guided tour and going about freely.

## One of VisitDirector's contents.
signal chosen(content: StringName)

@onready var _tour: Button = %Tour
@onready var _flight: Button = %Flight


func _ready() -> void:
	_tour.pressed.connect(chosen.emit.bind(VisitDirector.TOUR))
	_flight.pressed.connect(chosen.emit.bind(VisitDirector.FLIGHT))


func get_first_focus() -> Control:
	return _tour
