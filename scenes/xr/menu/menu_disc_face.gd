# SPDX-License-Identifier: MIT
class_name MenuDiscFace
extends Control
## What the menu's disc looks like: three lines on a round ground, and the word below.

## The disc's diameter in the picture's width.
const DISC: float = 0.42
const EM: float = 0.31

var lit: bool = false:
	set(to):
		lit = to
		queue_redraw()

var _ground := MenuLook.box(MenuLook.PANEL, MenuLook.SOFT)


func _init() -> void:
	set_anchors_preset(Control.PRESET_FULL_RECT)
	mouse_filter = Control.MOUSE_FILTER_IGNORE
	_ground.set_corner_radius_all(1000)
	_ground.set_border_width_all(5)


func _draw() -> void:
	var disc := DISC * size.x
	var frame := Rect2(0.5 * (size.x - disc), 6.0, disc, disc)
	_ground.bg_color = MenuLook.ACCENT if lit else MenuLook.PANEL
	_ground.border_color = MenuLook.ACCENT if lit else MenuLook.SOFT
	draw_style_box(_ground, frame)
	var ink := MenuLook.ON_ACCENT if lit else MenuLook.TEXT
	for line in range(-1, 2):
		var at := frame.get_center() + Vector2(0.0, line * 0.19 * disc)
		var half := Vector2(0.25 * disc, 0.0)
		draw_line(at - half, at + half, ink, 0.085 * disc, true)
	_write(tr("Menu"), frame.end.y, MenuLook.ACCENT if lit else MenuLook.TEXT)


func _write(text: String, top: float, colour: Color) -> void:
	var font := get_theme_default_font()
	var em := roundi(EM * size.x)
	var across := font.get_string_size(text, HORIZONTAL_ALIGNMENT_LEFT, -1.0, em).x
	var at := Vector2(0.5 * (size.x - across), top + font.get_ascent(em))
	var outline := roundi(0.25 * em)
	var left := HORIZONTAL_ALIGNMENT_LEFT
	draw_string_outline(font, at, text, left, -1.0, em, outline, Color(MenuLook.PANEL, 0.9))
	draw_string(font, at, text, left, -1.0, em, colour)
