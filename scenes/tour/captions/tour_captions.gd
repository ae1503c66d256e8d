# SPDX-License-Identifier: MIT
class_name TourCaptions
extends Control
## What a tour says: a band at the lower edge with the station's title, the caption, how far the
## tour is, and what can be done, by keys, gamepad, mouse or a pointing hand.
##
## It also holds the veil that darkens the picture while the eye goes elsewhere at once.

## Letters' heights at a text scale of 1, in pixels of a picture of 720 rows.
const TITLE_SIZE: int = 22
const TEXT_SIZE: int = 20
const SMALL_SIZE: int = 14
## Below the band, pixels.
const MARGIN: float = 24.0
const PAUSE: StringName = &"ride_pause"
## What keys and buttons are called on the screen, by what they do; that for the pause is a user's
## to choose.
const KEYS: Dictionary[StringName, String] = {
	&"previous": "←",
	&"next": "→",
	&"leave": "Escape",
}
const PADS: Dictionary[StringName, String] = {
	&"previous": "LB",
	&"next": "RB",
	&"leave": "B",
}

@export var guide: TourGuide
## How large the text is.
@export_range(0.5, 6.0, 0.05) var text_scale: float = 1.0:
	set(value):
		text_scale = clampf(value, 0.5, 6.0)
		_fit()
## Whether the captions' text is shown; title and buttons always are.
@export var captions_shown: bool = true:
	set(value):
		captions_shown = value
		_show_all()
## Whether the buttons say which keys do the same.
@export var keys_shown: bool = true:
	set(value):
		keys_shown = value
		_show_all()
## Width of the band; where there is less room, all of it.
@export_range(300.0, 4000.0, 1.0, "suffix:px") var width: float = 900.0:
	set(value):
		width = value
		_fit()
## How much larger still the buttons' text is.
@export_range(0.5, 3.0, 0.05) var small_scale: float = 1.0:
	set(value):
		small_scale = value
		_fit()
## The band keeps room for so many lines, so that it stays where it is.
@export_range(1, 8) var lines: int = 2:
	set(value):
		lines = value
		_fit()
## How long a new caption takes to come up.
@export_range(0.0, 2.0, 0.05, "suffix:s") var fade_seconds: float = 0.35
## How dark the picture behind the band is, 0 to 1.
@export_range(0.0, 1.0) var darkness: float = 0.0:
	set(value):
		darkness = clampf(value, 0.0, 1.0)
		_show_veil()

var _by_pad: bool = false
var _veil_tween: Tween
var _text_tween: Tween

@onready var _veil: ColorRect = %Veil
@onready var _band: Control = %Band
@onready var _title: Label = %Title
@onready var _number: Label = %Number
@onready var _text: Label = %Text
@onready var _progress: ProgressBar = %Progress
@onready var _buttons: Dictionary[StringName, Button] = {
	&"previous": %Previous,
	&"pause": %Pause,
	&"next": %Next,
	&"leave": %Leave,
}


func _ready() -> void:
	_band.hide()
	_buttons[&"previous"].pressed.connect(guide.previous)
	_buttons[&"pause"].pressed.connect(guide.toggle_pause)
	_buttons[&"next"].pressed.connect(guide.next)
	_buttons[&"leave"].pressed.connect(guide.leave)
	guide.caption_changed.connect(_on_caption_changed)
	guide.pause_changed.connect(_on_pause_changed)
	resized.connect(_fit)
	_show_veil()
	_fit()


func _process(_delta: float) -> void:
	# Under a menu the guide rests, and makes room for it.
	_band.visible = guide.is_on() and guide.is_processing()
	if _band.is_visible_in_tree():
		_progress.value = guide.get_progress()


func _notification(what: int) -> void:
	if what == NOTIFICATION_TRANSLATION_CHANGED:
		_show_all()


func _unhandled_input(event: InputEvent) -> void:
	if not (guide.is_on() and guide.is_processing()):
		return
	if not event.is_pressed() or event.is_echo() or not is_visible_in_tree():
		return
	if event is InputEventKey or event is InputEventJoypadButton:
		_note_device(event is InputEventJoypadButton)
		if _act(event):
			get_viewport().set_input_as_handled()


## Lets the picture come back.
func brighten(seconds: float) -> void:
	if darkness <= 0.0 or not is_inside_tree():
		darkness = 0.0
		return
	_veil_tween = create_tween()
	_veil_tween.tween_property(self, ^"darkness", 0.0, seconds)


## Which part of the picture's height lies below the band or under it, 0 to 1.
func get_covered_share() -> float:
	if not _band.is_visible_in_tree() or size.y <= 0.0:
		return 0.0
	# It may not have been laid out yet.
	return clampf((_band.get_combined_minimum_size().y + MARGIN) / size.y, 0.0, 1.0)


# Space is asked for first: it is among the keys that choose, too.
func _act(event: InputEvent) -> bool:
	var pad := event as InputEventJoypadButton
	var button := pad.button_index if pad != null else JOY_BUTTON_INVALID
	if event.is_action(PAUSE):
		guide.toggle_pause()
	elif event.is_action(&"ui_cancel"):
		guide.leave()
	elif event.is_action(&"ui_right") or event.is_action(&"ui_accept"):
		guide.next()
	elif event.is_action(&"ui_left") or button == JOY_BUTTON_LEFT_SHOULDER:
		guide.previous()
	elif button == JOY_BUTTON_RIGHT_SHOULDER:
		guide.next()
	elif event.is_action(&"ui_page_down") or event.is_action(&"ui_down"):
		guide.next_station()
	elif event.is_action(&"ui_page_up") or event.is_action(&"ui_up"):
		guide.previous_station()
	else:
		return false
	return true


func _note_device(is_pad: bool) -> void:
	if is_pad != _by_pad:
		_by_pad = is_pad
		_show_all()


func _on_caption_changed(_words: String) -> void:
	_show_all()
	if guide.is_on() and fade_seconds > 0.0:
		_text.modulate.a = 0.0
		if _text_tween != null:
			_text_tween.kill()
		_text_tween = create_tween()
		_text_tween.tween_property(_text, ^"modulate:a", 1.0, fade_seconds)


func _on_pause_changed(_paused: bool) -> void:
	_show_all()


func _show_all() -> void:
	if not is_node_ready():
		return
	_band.visible = guide.is_on()
	if not guide.is_on():
		return
	_title.text = tr(guide.get_station().title)
	_number.text = "%d / %d" % [guide.station_index + 1, guide.tour.stations.size()]
	_text.visible = captions_shown
	_text.text = tr(guide.get_words())
	_progress.value = guide.get_progress()
	var names: Dictionary[StringName, String] = {
		&"previous": tr("Previous"),
		&"pause": tr("Go on") if guide.is_paused() else tr("Pause"),
		&"next": tr("Next"),
		&"leave": tr("Leave"),
	}
	for what in _buttons:
		_buttons[what].text = names[what]
		if keys_shown:
			_buttons[what].text = "%s  [%s]" % [names[what], _key_of(what)]


func _key_of(what: StringName) -> String:
	if KEYS.has(what):
		return PADS[what] if _by_pad else tr(KEYS[what])
	var pause: Array[StringName] = [PAUSE]
	var bound := BindingNames.gamepad(pause) if _by_pad else BindingNames.keyboard(pause)
	return bound.get_slice(BindingNames.BETWEEN, 0)


func _show_veil() -> void:
	if is_node_ready():
		_veil.visible = darkness > 0.0
		_veil.color.a = darkness


func _fit() -> void:
	if not is_node_ready():
		return
	_title.add_theme_font_size_override(&"font_size", roundi(TITLE_SIZE * text_scale))
	_number.add_theme_font_size_override(
		&"font_size", roundi(SMALL_SIZE * text_scale * small_scale)
	)
	_text.add_theme_font_size_override(&"font_size", roundi(TEXT_SIZE * text_scale))
	var small := roundi(SMALL_SIZE * text_scale * small_scale)
	for button: Button in _buttons.values():
		button.add_theme_font_size_override(&"font_size", small)
	var room := maxf(size.x - 2.0 * MARGIN, 200.0)
	_band.custom_minimum_size.x = minf(width * maxf(text_scale, 1.0), room)
	var line := _text.get_theme_font(&"font").get_height(roundi(TEXT_SIZE * text_scale))
	_text.custom_minimum_size.y = ceilf(lines * line)
