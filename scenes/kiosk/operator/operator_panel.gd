# SPDX-License-Identifier: MIT
class_name OperatorPanel
extends MenuScreen
## What the operator sees and does: how the program is, and what may be done to it. On the screen,
## also while a visitor is in the headset.

signal recentre_asked
signal reset_asked
signal language_asked(locale: String)
signal volume_asked(volume: float)
signal comfort_asked(preset: Comfort.Preset)
signal restart_asked
signal quit_asked

## Between two looks at the facts, seconds.
const LOOK_SECONDS: float = 0.5
const VOLUME_STEP: float = 0.1

## Asked for what is shown: keys are English texts, values are ready to be read.
var facts := Callable()
## Asked for the last errors, the newest first.
var errors := Callable()

var _since_look: float = INF
var _locales: PackedStringArray = []
var _values: Dictionary[String, Label] = {}

@onready var _grid: GridContainer = %Facts
@onready var _errors: Label = %Errors
@onready var _language: Stepper = %Language
@onready var _volume: Stepper = %Volume
@onready var _comfort: Stepper = %Comfort
@onready var _recentre: Button = %Recentre
@onready var _reset: Button = %Reset
@onready var _restart: Button = %Restart
@onready var _quit: Button = %Quit
@onready var _close: Button = %Close


func _ready() -> void:
	_recentre.pressed.connect(recentre_asked.emit)
	_reset.pressed.connect(reset_asked.emit)
	_restart.pressed.connect(restart_asked.emit)
	_quit.pressed.connect(quit_asked.emit)
	_close.pressed.connect(close)
	_language.chosen.connect(func(at: int) -> void: language_asked.emit(_locales[at]))
	_volume.chosen.connect(func(at: int) -> void: volume_asked.emit(at * VOLUME_STEP))
	_comfort.chosen.connect(_on_comfort_chosen)


func _process(delta: float) -> void:
	_since_look += delta
	if visible and _since_look >= LOOK_SECONDS:
		_since_look = 0.0
		_look()


func get_first_focus() -> Control:
	return _recentre


## What can be chosen, and what is chosen now.
func offer(locales: PackedStringArray, locale: String, volume: float, comfort: Comfort) -> void:
	_locales = locales
	var titles: PackedStringArray = []
	for one in locales:
		titles.append(LanguagePage.title(one))
	_language.titles = titles
	_language.at = maxi(locales.find(locale), 0)
	var steps: PackedStringArray = []
	for step in roundi(1.0 / VOLUME_STEP) + 1:
		steps.append("%d %%" % roundi(100.0 * VOLUME_STEP * step))
	_volume.titles = steps
	_volume.at = roundi(volume / VOLUME_STEP)
	(%ComfortRow as Control).visible = comfort != null
	_comfort.titles = PackedStringArray([tr("Comfort"), tr("Free")])
	_comfort.at = comfort.preset if comfort != null else 0


func _on_open() -> void:
	_since_look = INF
	_look()


func _on_comfort_chosen(at: int) -> void:
	comfort_asked.emit(at as Comfort.Preset)


func _look() -> void:
	if not facts.is_valid():
		return
	var told: Dictionary = facts.call()
	for title: String in told:
		if not _values.has(title):
			_add_row(title)
		_values[title].text = str(told[title])
	var texts: PackedStringArray = errors.call()
	_errors.text = "\n".join(texts.slice(0, 5)) if not texts.is_empty() else tr("none")


func _add_row(fact: String) -> void:
	var title := Label.new()
	title.text = fact
	title.theme_type_variation = &"Caption"
	var value := Label.new()
	value.auto_translate_mode = Node.AUTO_TRANSLATE_MODE_DISABLED
	value.text_overrun_behavior = TextServer.OVERRUN_TRIM_ELLIPSIS
	value.custom_minimum_size.x = 330.0
	_grid.add_child(title)
	_grid.add_child(value)
	_values[fact] = value
