# SPDX-License-Identifier: MIT
class_name MenuRow
extends Button
## A big button of the menu: its words at the left; at the right a switch, the present choice, a
## mark, or an arrow to another page.

## Height of an em, pixels.
var em: int = 52:
	set(to):
		em = to
		custom_minimum_size.y = 1.42 * em
		for box: StyleBoxFlat in [_plain, _lit, _refused, _lit_refused]:
			box.set_corner_radius_all(roundi(0.35 * em))
		_lit_refused.set_border_width_all(maxi(roundi(0.08 * em), 2))
		queue_redraw()
## Null for a row of the menu's own.
var item: MenuItem
var words: String:
	set(to):
		if to != words:
			words = to
			queue_redraw()
## A bool, a String, or null: nothing.
var value: Variant:
	set(to):
		if not is_same(to, value):
			value = to
			queue_redraw()
## Pointed at, switched off or not.
var lit: bool = false:
	set(to):
		if to != lit:
			lit = to
			queue_redraw()

var _plain := MenuLook.box(MenuLook.BOX)
var _lit := MenuLook.box(MenuLook.ACCENT)
var _refused := MenuLook.box(MenuLook.BOX.darkened(0.45))
var _lit_refused := MenuLook.box(MenuLook.BOX.darkened(0.45), MenuLook.ACCENT)
var _pill := MenuLook.box(MenuLook.ACCENT)


func _init() -> void:
	focus_mode = Control.FOCUS_NONE
	action_mode = BaseButton.ACTION_MODE_BUTTON_PRESS
	_pill.set_corner_radius_all(1000)
	auto_translate_mode = Node.AUTO_TRANSLATE_MODE_DISABLED
	for style: StringName in [&"normal", &"hover", &"pressed", &"hover_pressed", &"disabled"]:
		add_theme_stylebox_override(style, StyleBoxEmpty.new())


## The room that words and value need beside each other, pixels.
func get_needed_width() -> float:
	var right := _right_width()
	return 2.0 * _margin() + _width_of(words) + (right + 0.5 * em if right > 0.0 else 0.0)


## The colour of its words as it is now.
func get_text_colour() -> Color:
	if disabled:
		return MenuLook.GREY
	return MenuLook.ON_ACCENT if lit else MenuLook.TEXT


func _draw() -> void:
	var box := _plain
	if disabled:
		box = _lit_refused if lit else _refused
	elif lit:
		box = _lit
	draw_style_box(box, Rect2(Vector2.ZERO, size))
	var colour := get_text_colour()
	_write(words, _margin(), colour)
	var right := size.x - _margin() - (0.3 * em if _is_page() else _right_width())
	if value is String:
		_write(str(value), right, colour if disabled or lit else MenuLook.ACCENT)
	elif _is_switch():
		_draw_switch(Vector2(right, 0.5 * size.y), value == true, colour)
	elif value is bool and value:
		_draw_mark(Vector2(right, 0.5 * size.y), colour if disabled or lit else MenuLook.ACCENT)
	elif _is_page():
		_draw_arrow(Vector2(right, 0.5 * size.y), colour)
		if item.bears_globe:
			_draw_globe(Vector2(right - 0.85 * em, 0.5 * size.y), colour)


func _is_switch() -> bool:
	return item != null and item.kind == MenuItem.Kind.TOGGLE and value is bool


func _is_page() -> bool:
	return item != null and item.kind == MenuItem.Kind.PAGE


func _margin() -> float:
	return 0.55 * em


func _right_width() -> float:
	if value is String:
		return _width_of(str(value))
	if _is_switch():
		return 1.5 * em
	if value is bool and value:
		return 0.7 * em
	if _is_page():
		return 1.5 * em if item.bears_globe else 0.3 * em
	return 0.0


func _font() -> Font:
	return get_theme_default_font()


func _width_of(written: String) -> float:
	return _font().get_string_size(written, HORIZONTAL_ALIGNMENT_LEFT, -1.0, em).x


func _write(written: String, x: float, colour: Color) -> void:
	var middle := 0.5 * (_font().get_ascent(em) - _font().get_descent(em))
	var at := Vector2(x, 0.5 * size.y + middle)
	draw_string(_font(), at, written, HORIZONTAL_ALIGNMENT_LEFT, -1.0, em, colour)


func _draw_switch(from: Vector2, is_on: bool, colour: Color) -> void:
	var height := 0.8 * em
	var frame := Rect2(from.x, from.y - 0.5 * height, 1.5 * em, height)
	_pill.draw_center = is_on
	_pill.bg_color = colour if disabled or lit else MenuLook.ACCENT
	_pill.border_color = _pill.bg_color if is_on else colour
	_pill.set_border_width_all(maxi(roundi(0.07 * em), 2))
	draw_style_box(_pill, frame)
	var knob := MenuLook.BOX if is_on else colour
	if is_on and lit and not disabled:
		knob = MenuLook.ACCENT
	var x := frame.end.x - 0.5 * height if is_on else frame.position.x + 0.5 * height
	draw_circle(Vector2(x, from.y), 0.26 * em, knob, true, -1.0, true)


func _draw_mark(from: Vector2, colour: Color) -> void:
	var tick: PackedVector2Array = [Vector2(0.0, 0.02), Vector2(0.24, 0.26), Vector2(0.7, -0.28)]
	_draw_stroke(tick, from, colour)


func _draw_arrow(from: Vector2, colour: Color) -> void:
	var arrow: PackedVector2Array = [Vector2(0.0, -0.3), Vector2(0.3, 0.0), Vector2(0.0, 0.3)]
	_draw_stroke(arrow, from, colour)


func _draw_globe(middle: Vector2, colour: Color) -> void:
	var radius := 0.36 * em
	var breadth := 0.06 * em
	draw_arc(middle, radius, 0.0, TAU, 48, colour, breadth, true)
	draw_set_transform(middle, 0.0, Vector2(0.45, 1.0))
	draw_arc(Vector2.ZERO, radius, 0.0, TAU, 48, colour, breadth, true)
	draw_set_transform(Vector2.ZERO)
	for line in range(-1, 2):
		var half := Vector2(sqrt(1.0 - 0.25 * line * line) * radius, 0.0)
		var at := middle + Vector2(0.0, 0.5 * line * radius)
		draw_line(at - half, at + half, colour, breadth, true)


func _draw_stroke(points: PackedVector2Array, from: Vector2, colour: Color) -> void:
	var line := Transform2D(0.0, Vector2.ONE * em, 0.0, from) * points
	draw_polyline(line, colour, 0.11 * em, true)
