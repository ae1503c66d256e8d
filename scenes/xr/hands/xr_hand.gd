# SPDX-License-Identifier: MIT
class_name XrHand
extends XRController3D
## A hand: where it points, and what its buttons mean. Which device it holds is the action map's
## matter; a hand that is not there presses nothing.

## The choosing button has been pressed, or let go.
signal chosen
signal let_go
## The menu's button has been pressed.
signal menu_asked
## The hand has come, or gone: switched on and in sight, or not.
signal presence_changed(here: bool)

## A trigger counts as pressed from here on, and as let go below.
const PRESSED: float = 0.7
const LET_GO: float = 0.4
## Sticks rest a little off their middle.
const DEAD_ZONE: float = 0.15

var _is_pressed: bool = false
var _is_menu_pressed: bool = false
var _was_here: bool = false


func _process(_delta: float) -> void:
	var here := is_here()
	if here != _was_here:
		_was_here = here
		presence_changed.emit(here)
	_follow_choice(get_float(&"select") if here else 0.0)
	var menu := here and is_button_pressed(&"menu")
	if menu and not _is_menu_pressed:
		menu_asked.emit()
	_is_menu_pressed = menu


## Switched on and in sight?
func is_here() -> bool:
	return get_is_active() and get_has_tracking_data()


## Is the choosing button held down?
func is_choosing() -> bool:
	return _is_pressed


## The stick: x to the right, y forwards, each -1 to 1, nothing in the dead zone.
func get_steer() -> Vector2:
	if not is_here():
		return Vector2.ZERO
	var stick := get_vector2(&"steer")
	var length := stick.length()
	if length <= DEAD_ZONE:
		return Vector2.ZERO
	return stick / length * minf((length - DEAD_ZONE) / (1.0 - DEAD_ZONE), 1.0)


## How firmly the hand is closed, 0 to 1.
func get_grip() -> float:
	return clampf(get_float(&"grab"), 0.0, 1.0) if is_here() else 0.0


## Where the hand points, in the world.
func get_direction() -> Vector3:
	return -global_basis.z.normalized()


## A short trembling of the hand, strength 0 to 1.
func pulse(strength: float, seconds: float = 0.03) -> void:
	if is_here():
		trigger_haptic_pulse(&"pulse", 0.0, strength, seconds, 0.0)


func _follow_choice(pull: float) -> void:
	if not _is_pressed and pull >= PRESSED:
		_is_pressed = true
		chosen.emit()
	elif _is_pressed and pull < LET_GO:
		_is_pressed = false
		let_go.emit()
