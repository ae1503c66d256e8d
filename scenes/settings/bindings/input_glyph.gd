# SPDX-License-Identifier: MIT
class_name InputGlyph
extends Control
## Draws a key, a mouse or a control of a gamepad, as large as the text beside it. Its words are for
## screen readers and the tool tip.

enum Mouse { DRAG_ACROSS, DRAG_ALONG, WHEEL }

const LINE := Color(0.72, 0.8, 0.95)
const CAP := Color(0.16, 0.2, 0.29)
const CAP_EDGE := Color(0.42, 0.5, 0.66)
const INK := Color(0.95, 0.97, 1.0)
const BODY := Color(0.1, 0.13, 0.19)
const LIT := Color(1.0, 0.8, 0.42)
## Letters of the four buttons, in the colours that most gamepads have.
const LETTERS: Dictionary[JoyButton, Color] = {
	JOY_BUTTON_A: Color(0.45, 0.85, 0.45),
	JOY_BUTTON_B: Color(1.0, 0.47, 0.43),
	JOY_BUTTON_X: Color(0.47, 0.7, 1.0),
	JOY_BUTTON_Y: Color(1.0, 0.83, 0.36),
}
const DIRECTIONS: Dictionary[JoyButton, Vector2] = {
	JOY_BUTTON_DPAD_UP: Vector2.UP,
	JOY_BUTTON_DPAD_DOWN: Vector2.DOWN,
	JOY_BUTTON_DPAD_LEFT: Vector2.LEFT,
	JOY_BUTTON_DPAD_RIGHT: Vector2.RIGHT,
}
const ARROW_KEYS: Dictionary[Key, Vector2] = {
	KEY_UP: Vector2.UP,
	KEY_DOWN: Vector2.DOWN,
	KEY_LEFT: Vector2.LEFT,
	KEY_RIGHT: Vector2.RIGHT,
}

var _event: InputEvent
var _mouse: int = -1
## What is written in it, if anything is.
var _caption: String = ""


static func of_event(event: InputEvent) -> InputGlyph:
	var glyph := InputGlyph.new()
	glyph._event = event
	glyph._set_up(BindingNames.of_event(event))
	return glyph


static func of_mouse(what: Mouse) -> InputGlyph:
	var glyph := InputGlyph.new()
	glyph._mouse = what
	glyph._set_up(_translated("Wheel") if what == Mouse.WHEEL else _translated("Drag"))
	return glyph


func _notification(what: int) -> void:
	if what == NOTIFICATION_THEME_CHANGED and is_inside_tree():
		_fit()
	elif what == NOTIFICATION_ENTER_TREE:
		_fit()


func _draw() -> void:
	if _mouse >= 0 or _event is InputEventMouseButton:
		_draw_mouse()
	elif _event is InputEventKey:
		_draw_key()
	elif _event is InputEventJoypadMotion:
		_draw_axis(_event as InputEventJoypadMotion)
	elif _event is InputEventJoypadButton:
		_draw_button((_event as InputEventJoypadButton).button_index)


func _set_up(words: String) -> void:
	mouse_filter = Control.MOUSE_FILTER_PASS
	tooltip_text = words
	auto_translate_mode = Node.AUTO_TRANSLATE_MODE_DISABLED
	size_flags_vertical = Control.SIZE_SHRINK_CENTER
	_caption = _caption_of(words)


# What is drawn needs no words but on caps, shoulder buttons and the small ones in the middle.
func _caption_of(words: String) -> String:
	if _event is InputEventKey:
		return "" if ARROW_KEYS.has(_key()) else words
	if _event is InputEventJoypadMotion:
		var axis := (_event as InputEventJoypadMotion).axis
		return words if axis in [JOY_AXIS_TRIGGER_LEFT, JOY_AXIS_TRIGGER_RIGHT] else ""
	if _event is InputEventJoypadButton:
		var button := (_event as InputEventJoypadButton).button_index
		var drawn := DIRECTIONS.has(button)
		drawn = drawn or button in [JOY_BUTTON_LEFT_STICK, JOY_BUTTON_RIGHT_STICK]
		return "" if drawn else words
	return ""


func _key() -> Key:
	var event := _event as InputEventKey
	return event.keycode if event.physical_keycode == KEY_NONE else event.physical_keycode


func _fit() -> void:
	var pixels := _font_size()
	var height := roundf(pixels * 1.9)
	var width := height
	if not _caption.is_empty():
		var written := get_theme_default_font().get_string_size(
			_caption, HORIZONTAL_ALIGNMENT_LEFT, -1.0, pixels
		)
		width = maxf(height, ceilf(written.x + 0.9 * pixels))
	custom_minimum_size = Vector2(width, height)
	queue_redraw()


func _font_size() -> int:
	return get_theme_font_size(&"font_size", &"Caption")


func _draw_key() -> void:
	_draw_cap(Rect2(Vector2.ZERO, size).grow(-1.0), 0.22 * size.y)
	if ARROW_KEYS.has(_key()):
		_draw_arrow(0.5 * size - Vector2(0.0, 1.0), ARROW_KEYS[_key()], 0.22 * size.y, INK)
	else:
		_write(INK, -1.0)


func _draw_button(button: JoyButton) -> void:
	var middle := 0.5 * size
	if LETTERS.has(button):
		draw_circle(middle, 0.46 * size.y, BODY)
		draw_circle(middle, 0.46 * size.y, LETTERS[button], false, 1.5, true)
		_write(LETTERS[button], 0.0)
	elif DIRECTIONS.has(button):
		_draw_cross(DIRECTIONS[button])
	elif button in [JOY_BUTTON_LEFT_STICK, JOY_BUTTON_RIGHT_STICK]:
		_draw_stick(button == JOY_BUTTON_LEFT_STICK, Vector2.ZERO)
	elif button in [JOY_BUTTON_LEFT_SHOULDER, JOY_BUTTON_RIGHT_SHOULDER]:
		_draw_shoulder(0.5, button == JOY_BUTTON_LEFT_SHOULDER)
	else:
		_draw_cap(Rect2(Vector2.ZERO, size).grow(-1.0), 0.5 * size.y)
		_write(INK, -1.0)


func _draw_axis(event: InputEventJoypadMotion) -> void:
	var way := signf(event.axis_value)
	match event.axis:
		JOY_AXIS_TRIGGER_LEFT, JOY_AXIS_TRIGGER_RIGHT:
			_draw_shoulder(1.0, event.axis == JOY_AXIS_TRIGGER_LEFT)
		JOY_AXIS_LEFT_X, JOY_AXIS_RIGHT_X:
			_draw_stick(event.axis == JOY_AXIS_LEFT_X, Vector2(way, 0.0))
		_:
			_draw_stick(event.axis == JOY_AXIS_LEFT_Y, Vector2(0.0, way))


func _draw_cap(area: Rect2, radius: float) -> void:
	var box := StyleBoxFlat.new()
	box.bg_color = CAP
	box.border_color = CAP_EDGE
	box.set_border_width_all(1)
	box.border_width_bottom = 3
	box.set_corner_radius_all(roundi(radius))
	draw_style_box(box, area)


# A bumper is flat, a trigger tall; the outer upper corner is the round one.
func _draw_shoulder(tall: float, left: bool) -> void:
	var box := StyleBoxFlat.new()
	box.bg_color = CAP
	box.border_color = CAP_EDGE
	box.set_border_width_all(1)
	box.set_corner_radius_all(4)
	var radius := roundi((0.3 + 0.25 * tall) * size.y)
	if left:
		box.corner_radius_top_left = radius
	else:
		box.corner_radius_top_right = radius
	var area := Rect2(Vector2.ZERO, size).grow(-1.0)
	if tall < 1.0:
		area = area.grow_individual(0.0, -0.08 * size.y, 0.0, -0.08 * size.y)
	draw_style_box(box, area)
	_write(INK, 0.0)


# The stick leans away from the middle, to where the arrow points; pressed it is lit.
func _draw_stick(left: bool, way: Vector2) -> void:
	var still := way == Vector2.ZERO
	var at := 0.5 * size - way * 0.13 * size.y
	var radius := (0.42 if still else 0.32) * size.y
	draw_circle(at, radius, BODY)
	draw_circle(at, radius, CAP_EDGE, false, 1.0, true)
	draw_circle(at, 0.26 * size.y, LIT if still else CAP)
	draw_circle(at, 0.26 * size.y, LINE, false, 1.0, true)
	var pixels := roundi(0.36 * size.y)
	var font := get_theme_default_font()
	var letter := "L" if left else "R"
	var extent := font.get_string_size(letter, HORIZONTAL_ALIGNMENT_LEFT, -1.0, pixels)
	var base := at + Vector2(-0.5 * extent.x, 0.36 * pixels)
	var ink := BODY if still else INK
	draw_string(font, base, letter, HORIZONTAL_ALIGNMENT_LEFT, -1.0, pixels, ink)
	if not still:
		_draw_arrow(0.5 * size + way * 0.36 * size.y, way, 0.16 * size.y, LIT)


func _draw_cross(lit: Vector2) -> void:
	var middle := 0.5 * size
	var arm := 0.3 * size.y
	for way: Vector2 in DIRECTIONS.values():
		var end := middle + way * 0.3 * size.y
		var area := Rect2(end, Vector2.ZERO).grow(0.5 * arm)
		draw_rect(area, LIT if way == lit else CAP_EDGE)
	draw_rect(Rect2(middle, Vector2.ZERO).grow(0.5 * arm), CAP_EDGE)


func _draw_mouse() -> void:
	var body := Rect2(0.5 * size, Vector2.ZERO).grow_individual(
		0.26 * size.y, 0.36 * size.y, 0.26 * size.y, 0.36 * size.y
	)
	var box := StyleBoxFlat.new()
	box.bg_color = BODY
	box.border_color = LINE
	box.set_border_width_all(1)
	box.set_corner_radius_all(roundi(0.26 * size.y))
	draw_style_box(box, body)
	var seam := body.position.y + 0.45 * body.size.y
	draw_line(Vector2(body.position.x + 1.0, seam), Vector2(body.end.x - 1.0, seam), LINE, 1.0)
	if _mouse == Mouse.DRAG_ACROSS or _mouse == Mouse.DRAG_ALONG:
		_draw_drag(body, seam)
		return
	var button := MOUSE_BUTTON_NONE
	if _event is InputEventMouseButton:
		button = (_event as InputEventMouseButton).button_index
	var wheel := Rect2(Vector2(0.5 * size.x, body.position.y + 0.24 * body.size.y), Vector2.ZERO)
	var lit := _mouse == Mouse.WHEEL or button == MOUSE_BUTTON_MIDDLE
	draw_rect(wheel.grow_individual(2.0, 4.0, 2.0, 4.0), LIT if lit else LINE)
	if button in [MOUSE_BUTTON_XBUTTON1, MOUSE_BUTTON_XBUTTON2]:
		var at := seam + (0.22 if button == MOUSE_BUTTON_XBUTTON1 else 0.02) * body.size.y
		draw_rect(Rect2(body.position.x - 2.0, at, 4.0, 0.16 * body.size.y), LIT)


# The left button is lit, and arrows tell the way.
func _draw_drag(body: Rect2, seam: float) -> void:
	var box := StyleBoxFlat.new()
	box.bg_color = LIT
	box.corner_radius_top_left = roundi(0.26 * size.y)
	var corner := body.position + Vector2.ONE
	draw_style_box(box, Rect2(corner, Vector2(0.5 * size.x, seam) - corner))
	var across := _mouse == Mouse.DRAG_ACROSS
	for way: Vector2 in [Vector2.LEFT, Vector2.RIGHT] if across else [Vector2.UP, Vector2.DOWN]:
		_draw_arrow(0.5 * size + way * (0.4 if across else 0.43) * size.y, way, 0.11 * size.y, LIT)


func _draw_arrow(at: Vector2, way: Vector2, length: float, colour: Color) -> void:
	var side := way.orthogonal() * length
	var tip := at + way * length * 0.8
	var foot := at - way * length * 0.5
	draw_colored_polygon(PackedVector2Array([tip, foot + side, foot - side]), colour)


func _write(colour: Color, raised: float) -> void:
	var font := get_theme_default_font()
	var pixels := _font_size()
	var extent := font.get_string_size(_caption, HORIZONTAL_ALIGNMENT_LEFT, -1.0, pixels)
	var base := 0.5 * size + Vector2(-0.5 * extent.x, 0.36 * pixels + raised)
	draw_string(font, base, _caption, HORIZONTAL_ALIGNMENT_LEFT, -1.0, pixels, colour)


static func _translated(text: String) -> String:
	return TranslationServer.translate(text)
