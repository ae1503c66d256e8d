# SPDX-License-Identifier: MIT
class_name IdlePointer
extends Node
## Takes the mouse pointer off the picture while the mouse rests.

const REST_SECONDS: float = 3.0

## The pointer stays while a page is open.
var kept: bool = false

var _rested: float = 0.0


func _process(delta: float) -> void:
	_rested += delta
	if _rested > REST_SECONDS and not kept:
		_set_mode(Input.MOUSE_MODE_HIDDEN)


func _input(event: InputEvent) -> void:
	if event is InputEventMouse:
		wake()


func _exit_tree() -> void:
	_set_mode(Input.MOUSE_MODE_VISIBLE)


## Shows the pointer again.
func wake() -> void:
	_rested = 0.0
	_set_mode(Input.MOUSE_MODE_VISIBLE)


func _set_mode(mode: Input.MouseMode) -> void:
	if Input.mouse_mode != mode:
		Input.mouse_mode = mode
