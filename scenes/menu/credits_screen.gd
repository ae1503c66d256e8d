# SPDX-License-Identifier: MIT
class_name CreditsScreen
extends MenuScreen
## The credits, and on a second page the licences in full. Up and down scroll the page, with the
## wheel, keys and stick alike.

## Pixels per second while a direction is held.
const SCROLL_SPEED: float = 620.0
const PAGE_SHARE: float = 0.85
## Of a heading with the room above it, pixels.
const TITLE_HEIGHT: float = 44.0

var _show_licences: bool = false
var _position: float = 0.0

@onready var _heading: Label = %Heading
@onready var _scroll: ScrollContainer = %Scroll
@onready var _entries: VBoxContainer = %Entries
@onready var _licences: RichTextLabel = %Licences
@onready var _switch: Button = %Switch
@onready var _close: Button = %Close


func _ready() -> void:
	_switch.pressed.connect(func() -> void: show_licences(not _show_licences))
	_close.pressed.connect(close)
	set_process(visible)
	visibility_changed.connect(func() -> void: set_process(visible))


func _notification(what: int) -> void:
	if what == NOTIFICATION_TRANSLATION_CHANGED and is_node_ready() and visible:
		show_licences(_show_licences)


func _process(delta: float) -> void:
	var held := Input.get_axis(&"ui_up", &"ui_down")
	if held != 0.0:
		_scroll_by(held * SCROLL_SPEED * delta)


func _input(event: InputEvent) -> void:
	if not visible:
		return
	if event.is_action_pressed(&"ui_page_down", true):
		_scroll_by(PAGE_SHARE * _scroll.size.y)
	elif event.is_action_pressed(&"ui_page_up", true):
		_scroll_by(-PAGE_SHARE * _scroll.size.y)
	elif event.is_action_pressed(&"ui_home"):
		_scroll_to(0.0)
	elif event.is_action_pressed(&"ui_end"):
		_scroll_to(INF)
	else:
		return
	get_viewport().set_input_as_handled()


## The second page rather than the first.
func show_licences(shown: bool) -> void:
	_show_licences = shown
	_heading.text = tr("Licences") if shown else tr("Credits")
	_switch.text = tr("Credits") if shown else tr("Licences")
	_entries.visible = not shown
	_licences.visible = shown
	if shown and _licences.get_total_character_count() == 0:
		_fill_licences()
	elif not shown:
		_fill_entries()
	_scroll_to(0.0)


func get_first_focus() -> Control:
	return _close


func _on_open() -> void:
	show_licences(false)


func _scroll_to(place: float) -> void:
	_position = 0.0
	_scroll.scroll_vertical = 0
	if place > 0.0:
		_scroll_by(_entries.size.y + _licences.size.y)


# Parts of a pixel count too, or a slow stick would not move it.
func _scroll_by(pixels: float) -> void:
	if absf(_position - _scroll.scroll_vertical) >= 1.0:
		_position = _scroll.scroll_vertical
	_position += pixels
	_scroll.scroll_vertical = roundi(_position)
	_position = clampf(_position, 0.0, _scroll.scroll_vertical + 1.0)


func _fill_entries() -> void:
	for label in _entries.get_children():
		label.free()
	for entry in CreditsText.entries():
		_add(entry.title, &"CreditsTitle", TITLE_HEIGHT)
		_add(entry.text, &"Label", 0.0)


func _add(text: String, kind: StringName, height: float) -> void:
	var label := Label.new()
	label.custom_minimum_size.y = height
	label.vertical_alignment = VERTICAL_ALIGNMENT_BOTTOM
	label.text = text
	label.theme_type_variation = kind
	label.auto_translate_mode = Node.AUTO_TRANSLATE_MODE_DISABLED
	label.autowrap_mode = TextServer.AUTOWRAP_WORD_SMART
	_entries.add_child(label)


func _fill_licences() -> void:
	for entry in CreditsText.licences():
		_licences.push_color(get_theme_color(&"font_color", &"CreditsTitle"))
		_licences.add_text(entry.title)
		_licences.pop()
		_licences.add_text("\n%s\n\n" % entry.text)
