# SPDX-License-Identifier: MIT
class_name SettingRow
extends VBoxContainer
## One setting on the screen: its name, what left and right change, and a line that explains it.

## Width of what is changed, in pixels.
const WIDTH: float = 330.0
const VALUE_WIDTH: float = 64.0

var setting: Setting

var _settings: UserSettings
var _name := Label.new()
var _note: Label
var _slider: ValueSlider
var _stepper: Stepper


func _init(of: Setting, settings: UserSettings) -> void:
	setting = of
	_settings = settings
	add_theme_constant_override(&"separation", 0)
	var line := HBoxContainer.new()
	line.add_theme_constant_override(&"separation", 24)
	add_child(line)
	_name.size_flags_horizontal = Control.SIZE_EXPAND_FILL
	_name.auto_translate_mode = Node.AUTO_TRANSLATE_MODE_DISABLED
	line.add_child(_name)
	line.add_child(_make_slider() if setting.kind == Setting.Kind.NUMBER else _make_stepper())
	if not setting.note.is_empty():
		_add_note()


func _ready() -> void:
	refresh()
	_settings.changed.connect(_on_changed)


func _notification(what: int) -> void:
	if what == NOTIFICATION_TRANSLATION_CHANGED and is_node_ready():
		refresh()
	elif what == NOTIFICATION_THEME_CHANGED and is_node_ready() and _stepper != null:
		# It keeps room for the longest of its titles, as large as text is now.
		_stepper.titles = PackedStringArray()
		refresh.call_deferred()


# Sliders have no frame of their own.
func _draw() -> void:
	if _slider != null and _slider.has_focus():
		var both := _slider.get_parent_control()
		var area := Rect2(both.get_parent_control().position + both.position, both.size)
		draw_style_box(
			get_theme_stylebox(&"focus", &"Button"),
			area.grow_side(SIDE_LEFT, 8.0).grow_side(SIDE_RIGHT, 6.0)
		)


## What has the focus when the row is chosen.
func get_control() -> Control:
	if _slider != null:
		return _slider
	return _stepper


## Shows the present value in the present language.
func refresh() -> void:
	_name.text = tr(setting.title)
	get_control().accessibility_name = _name.text
	if _note != null:
		_note.text = tr(setting.note)
		get_control().accessibility_description = _note.text
	if _slider != null:
		var number := _settings.get_number(setting.key)
		_slider.display(number, setting.format % roundi(number))
	else:
		var titles := PackedStringArray()
		for title in setting.titles:
			titles.append(tr(title))
		_stepper.titles = titles
		_stepper.at = setting.place_of(_settings.get_value(setting.key))


func _make_slider() -> Control:
	var both := HBoxContainer.new()
	both.custom_minimum_size.x = WIDTH
	both.add_theme_constant_override(&"separation", 12)
	both.item_rect_changed.connect(queue_redraw)
	_slider = ValueSlider.new()
	_slider.min_value = setting.least
	_slider.max_value = setting.most
	_slider.step = setting.step
	_slider.size_flags_horizontal = Control.SIZE_EXPAND_FILL
	# As high as the text: so much comes into sight with the focus.
	_slider.size_flags_vertical = Control.SIZE_FILL
	_slider.label = Label.new()
	_slider.label.custom_minimum_size.x = VALUE_WIDTH
	_slider.label.horizontal_alignment = HORIZONTAL_ALIGNMENT_RIGHT
	_slider.label.auto_translate_mode = Node.AUTO_TRANSLATE_MODE_DISABLED
	_slider.focus_entered.connect(queue_redraw)
	_slider.focus_exited.connect(queue_redraw)
	both.add_child(_slider)
	both.add_child(_slider.label)
	_slider.value_changed.connect(_on_slid)
	return both


func _make_stepper() -> Control:
	# The stepper sets its own least width.
	var frame := HBoxContainer.new()
	frame.custom_minimum_size.x = WIDTH
	_stepper = Stepper.new()
	_stepper.size_flags_horizontal = Control.SIZE_EXPAND_FILL
	_stepper.chosen.connect(_on_chosen)
	frame.add_child(_stepper)
	return frame


func _add_note() -> void:
	_note = Label.new()
	_note.theme_type_variation = &"Caption"
	_note.auto_translate_mode = Node.AUTO_TRANSLATE_MODE_DISABLED
	_note.autowrap_mode = TextServer.AUTOWRAP_WORD_SMART
	add_child(_note)


func _on_slid(value: float) -> void:
	_settings.set_value(setting.key, value)


func _on_chosen(at: int) -> void:
	_settings.set_value(setting.key, setting.value_at(at))


func _on_changed(key: StringName) -> void:
	if key == setting.key:
		refresh()
