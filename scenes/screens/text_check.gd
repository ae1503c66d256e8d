# SPDX-License-Identifier: MIT
class_name TextCheck
extends RefCounted
## Whether the texts of a page can be read: nothing cut off, nothing over another, and enough
## contrast.

## Of text to its ground, as the Web Content Accessibility Guidelines ask for.
const LEAST_CONTRAST: float = 4.5
## Pixels that do not count.
const SLACK: float = 1.5


## The controls below `root` that show a text now.
static func texts(root: Node) -> Array[Control]:
	var found: Array[Control] = []
	for node in root.find_children("*", "Control", true, false):
		var control := node as Control
		if not control.is_visible_in_tree() or _text_of(control).strip_edges().is_empty():
			continue
		if _opacity(control) > 0.1 and _is_scrolled_into_view(control):
			found.append(control)
	return found


## What is wrong with where the texts below `root` are, in words; empty when all is well.
static func misplaced(root: Node) -> PackedStringArray:
	var problems := PackedStringArray()
	var found := texts(root)
	for control in found:
		var wrong := _misplacement(control)
		if not wrong.is_empty():
			problems.append('"%s": %s' % [_short(control), wrong])
	for i in found.size():
		for other: Control in found.slice(i + 1):
			if _are_over_each_other(found[i], other):
				problems.append('"%s" and "%s" overlap' % [_short(found[i]), _short(other)])
	return problems


## The texts below `root` that stand out too little in `picture`, a picture of their viewport.
static func faint(root: Node, picture: Image) -> PackedStringArray:
	var problems := PackedStringArray()
	for control in texts(root):
		var found := contrast(control, picture)
		if found < LEAST_CONTRAST:
			problems.append('"%s": contrast %.1f' % [_short(control), found])
	return problems


## Of a text to what is around it, from the pixels: its brightest (or darkest) to the median.
static func contrast(control: Control, picture: Image) -> float:
	var visible := control.get_viewport().get_visible_rect()
	var scale := Vector2(picture.get_size()) / visible.size
	var rect := _text_rect(control)
	var frame := Rect2i(Rect2(rect.position * scale, rect.size * scale))
	frame = frame.intersection(Rect2i(Vector2i.ZERO, picture.get_size()))
	var values := PackedFloat32Array()
	for y in range(frame.position.y, frame.end.y):
		for x in range(frame.position.x, frame.end.x):
			values.append(picture.get_pixel(x, y).srgb_to_linear().get_luminance())
	if values.is_empty():
		return 0.0
	values.sort()
	var last := values.size() - 1
	var ground := values[last >> 1] + 0.05
	return maxf(
		(values[int(0.99 * last)] + 0.05) / ground, ground / (values[int(0.01 * last)] + 0.05)
	)


static func _misplacement(control: Control) -> String:
	var rect := _text_rect(control)
	var window := control.get_viewport().get_visible_rect()
	if not window.grow(SLACK).encloses(rect):
		return "outside of the window"
	var box := _box_of(control)
	if box != null and not box.get_global_rect().grow(SLACK).encloses(rect):
		return "outside of its box"
	var label := control as Label
	if label != null:
		if label.get_visible_line_count() < label.get_line_count() and label.max_lines_visible < 0:
			return "lines are cut off"
		if label.autowrap_mode == TextServer.AUTOWRAP_OFF and _width(label) > label.size.x + SLACK:
			return "cut off"
	var button := control as Button
	if button != null and _width(button) > button.size.x + SLACK:
		return "cut off"
	return ""


static func _are_over_each_other(one: Control, other: Control) -> bool:
	if one.is_ancestor_of(other) or other.is_ancestor_of(one):
		return false
	var both := _text_rect(one).intersection(_text_rect(other))
	return both.size.x > 2.0 * SLACK and both.size.y > 3.0 * SLACK


static func _text_of(control: Control) -> String:
	if control is Label:
		return (control as Label).text
	if control is Button:
		return (control as Button).text
	if control is RichTextLabel:
		return (control as RichTextLabel).get_parsed_text()
	return ""


static func _short(control: Control) -> String:
	return control.atr(_text_of(control)).replace("\n", " ").left(40)


# Without what is free around the text.
static func _text_rect(control: Control) -> Rect2:
	var rect := control.get_global_rect()
	var button := control as Button
	if button != null:
		return _middle_of(rect, button)
	var label := control as Label
	if label == null:
		return rect
	var size := rect.size
	if label.autowrap_mode == TextServer.AUTOWRAP_OFF or label.get_line_count() == 1:
		size.x = minf(_width(label), size.x)
	size.y = minf(label.get_line_count() * label.get_line_height(), size.y)
	var free := rect.size - size
	var at := Vector2.ZERO
	if label.horizontal_alignment == HORIZONTAL_ALIGNMENT_CENTER:
		at.x = 0.5 * free.x
	elif label.horizontal_alignment == HORIZONTAL_ALIGNMENT_RIGHT:
		at.x = free.x
	if label.vertical_alignment == VERTICAL_ALIGNMENT_CENTER:
		at.y = 0.5 * free.y
	elif label.vertical_alignment == VERTICAL_ALIGNMENT_BOTTOM:
		at.y = free.y
	return Rect2(rect.position + at, size)


# Of a button with its text in the middle; of another the whole one.
static func _middle_of(rect: Rect2, button: Button) -> Rect2:
	if button.alignment != HORIZONTAL_ALIGNMENT_CENTER or button.icon != null:
		return rect
	var free := maxf(rect.size.x - _width(button), 0.0)
	return rect.grow_individual(-0.5 * free, 0.0, -0.5 * free, 0.0)


static func _width(control: Control) -> float:
	var font := control.get_theme_font(&"font")
	var size := control.get_theme_font_size(&"font_size")
	var widest := 0.0
	for line in control.atr(_text_of(control)).split("\n"):
		widest = maxf(widest, font.get_string_size(line, HORIZONTAL_ALIGNMENT_LEFT, -1, size).x)
	return widest


static func _opacity(control: Control) -> float:
	var alpha := 1.0
	var item: CanvasItem = control
	while item != null:
		alpha *= item.modulate.a
		item = item.get_parent() as CanvasItem
	return alpha * control.self_modulate.a


# The panel that it is meant to be in.
static func _box_of(control: Control) -> Control:
	var above := control.get_parent() as Control
	while above != null:
		if above is ScrollContainer:
			return null
		if above is PanelContainer or above is Panel:
			return above
		above = above.get_parent() as Control
	return null


static func _is_scrolled_into_view(control: Control) -> bool:
	var above := control.get_parent() as Control
	while above != null:
		if above is ScrollContainer and not above.get_global_rect().encloses(_text_rect(control)):
			return false
		above = above.get_parent() as Control
	return true
