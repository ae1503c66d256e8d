# SPDX-License-Identifier: MIT
class_name BindingCell
extends Button
## What one action has of one device, as glyphs; to be pressed for another binding.

## Keys that are left out beside another one of the same action.
const SECOND_KEYS: Array[Key] = BindingNames.SECOND_KEYS

## Pixels above and below the glyphs together.
const ROOM: float = 6.0

var action: StringName
var device: InputBindings.Device

var _glyphs := HBoxContainer.new()


func _init(of: StringName, from: InputBindings.Device) -> void:
	action = of
	device = from
	theme_type_variation = &"SmallButton"
	auto_translate_mode = Node.AUTO_TRANSLATE_MODE_DISABLED
	size_flags_horizontal = Control.SIZE_EXPAND_FILL
	clip_contents = true
	_glyphs.alignment = BoxContainer.ALIGNMENT_CENTER
	_glyphs.add_theme_constant_override(&"separation", 6)
	_glyphs.set_anchors_preset(Control.PRESET_FULL_RECT)
	_glyphs.mouse_filter = Control.MOUSE_FILTER_IGNORE
	_glyphs.minimum_size_changed.connect(_fit)
	add_child(_glyphs)


## Shows the events; `besides` is what the mouse does without a binding, and `clashes` whether
## another action has one of them too.
func display(events: Array[InputEvent], besides: String, clashes: bool) -> void:
	for glyph in _glyphs.get_children():
		glyph.free()
	match besides:
		"across":
			_add(InputGlyph.of_mouse(InputGlyph.Mouse.DRAG_ACROSS))
		"along":
			_add(InputGlyph.of_mouse(InputGlyph.Mouse.DRAG_ALONG))
		"wheel":
			_add(InputGlyph.of_mouse(InputGlyph.Mouse.WHEEL))
	for event in events:
		if not (event is InputEventKey and _is_second(event as InputEventKey, events)):
			_add(InputGlyph.of_event(event))
	if _glyphs.get_child_count() == 0:
		var none := Label.new()
		none.text = "–"
		none.theme_type_variation = &"Caption"
		_glyphs.add_child(none)
	if clashes:
		var mark := Label.new()
		mark.text = "!"
		mark.theme_type_variation = &"Warning"
		_glyphs.add_child(mark)


## What it shows, in words.
func words() -> String:
	var names := PackedStringArray()
	for glyph in _glyphs.get_children():
		if glyph is InputGlyph:
			names.append((glyph as InputGlyph).tooltip_text)
	return ", ".join(names)


# A button knows nothing of what lies on it.
func _fit() -> void:
	custom_minimum_size.y = _glyphs.get_combined_minimum_size().y + ROOM


func _add(glyph: InputGlyph) -> void:
	glyph.mouse_filter = Control.MOUSE_FILTER_IGNORE
	_glyphs.add_child(glyph)


func _is_second(event: InputEventKey, events: Array[InputEvent]) -> bool:
	return event != events[0] and SECOND_KEYS.has(event.keycode)
