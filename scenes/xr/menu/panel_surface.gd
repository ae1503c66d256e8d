# SPDX-License-Identifier: MIT
class_name PanelSurface
extends PointTarget
## A 2D scene in the world that one can point at: the ray is its mouse.

## Another button lies under the ray; null: none. One that is switched off counts here.
signal hovered(button: BaseButton)

## What is shown.
@export var scene: PackedScene
## Width in the world, metres.
@export_range(0.01, 10.0, 0.01, "suffix:m") var width: float = 1.92
## Size of the scene, pixels; its height in the world follows.
@export var pixels := Vector2i(1280, 992)
## So long a gaze rests on a button to press it.
@export_range(0.1, 10.0, 0.1, "suffix:s") var dwell: float = 1.3

var picture := FlatPicture.new()
## The root of what is shown.
var content: Control

var _motion := InputEventMouseMotion.new()
var _pixel := Vector2.ZERO
var _button: BaseButton
var _is_under_ray: bool = false
var _is_down: bool = false
## Changes of what lies under the ray until a usual wait is enough.
var _changes_to_wait: int = 0


func _ready() -> void:
	picture.pixels = pixels
	picture.width = width
	add_child(picture)
	if scene != null:
		show_content(scene.instantiate() as Control)


## Shows this in place of what was shown.
func show_content(shown: Control) -> void:
	if content != null:
		content.queue_free()
	content = shown
	picture.viewport.add_child(content)
	picture.redraw()


## Width and height in the world, metres.
func resize(metres: Vector2, across: int) -> void:
	width = metres.x
	pixels = Vector2i(across, roundi(across * metres.y / metres.x))
	picture.pixels = pixels
	picture.width = width


## Draws the scene anew.
func redraw() -> void:
	picture.redraw()


## What comes under a gaze by itself, because the scene changes, is to be read first: the gaze needs
## twice the time for the first button it finds there.
func hold_back() -> void:
	_changes_to_wait = 2


func distance_along(from: Vector3, direction: Vector3) -> float:
	return distance_to_flat(from, direction, picture.get_extent())


func point_at(place: Vector3) -> void:
	var viewport := picture.viewport
	if not _is_under_ray:
		_is_under_ray = true
		viewport.notification(NOTIFICATION_VP_MOUSE_ENTER)
	var pixel := picture.to_pixel(to_local(place))
	_motion.position = pixel
	_motion.global_position = pixel
	_motion.relative = pixel - _pixel
	_motion.button_mask = _mask()
	_pixel = pixel
	viewport.push_input(_motion, true)
	_hover(_button_under(viewport.gui_get_hovered_control()))


func leave() -> void:
	let_go()
	if _is_under_ray:
		_is_under_ray = false
		picture.viewport.notification(NOTIFICATION_VP_MOUSE_EXIT)
	_hover(null)


func dwell_seconds() -> float:
	return dwell * 2.0 if _changes_to_wait == 1 else dwell


func what_is_pointed_at() -> Variant:
	return _button if is_instance_valid(_button) and not _button.disabled else null


func choose() -> bool:
	var is_possible: bool = what_is_pointed_at() != null
	_is_down = true
	_push_click()
	return is_possible


func let_go() -> void:
	if _is_down:
		_is_down = false
		_push_click()


func _button_under(control: Control) -> BaseButton:
	while control != null and not control is BaseButton:
		control = control.get_parent_control()
	return control as BaseButton


func _hover(button: BaseButton) -> void:
	if is_same(button, _button):
		return
	_button = button
	_changes_to_wait = maxi(_changes_to_wait - 1, 0)
	picture.redraw()
	hovered.emit(button)


func _push_click() -> void:
	var click := InputEventMouseButton.new()
	click.button_index = MOUSE_BUTTON_LEFT
	click.pressed = _is_down
	click.button_mask = _mask()
	click.position = _pixel
	click.global_position = _pixel
	picture.viewport.push_input(click, true)
	picture.redraw()


func _mask() -> MouseButtonMask:
	return MOUSE_BUTTON_MASK_LEFT if _is_down else 0 as MouseButtonMask
