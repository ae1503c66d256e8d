# SPDX-License-Identifier: MIT
class_name HealthScreen
extends MenuScreen
## What visitors must know before they begin; they accept it or go back.

signal accepted

@onready var _accept: Button = %Accept
@onready var _back: Button = %Back


func _ready() -> void:
	_accept.pressed.connect(accepted.emit)
	_back.pressed.connect(close)


func get_first_focus() -> Control:
	return _accept
