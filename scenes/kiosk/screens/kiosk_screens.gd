# SPDX-License-Identifier: MIT
class_name KioskScreens
extends Control
## The exhibit's own pages, of which one at most is shown: the invitation, language, health notice,
## choice and thanks. The same for the screen and for the sign in the headset.

signal start_asked
signal language_chosen(locale: String)
signal health_accepted
signal content_chosen(content: StringName)
## The visitor wants to go a step back.
signal back_asked

## Shown on the sign in the headset.
var on_board: bool = false

var _texts_wanted: bool = true
var _languages: PackedStringArray = ["en"]
var _invitation: String = AttractScreen.BY_BUTTON
var _headset: bool = false
var _turning: bool = false

@onready var _attract: AttractScreen = $Attract
@onready var _language: LanguageScreen = $Language
@onready var _health: HealthScreen = $Health
@onready var _choice: ChoiceScreen = $Choice
@onready var _ending: EndingScreen = $Ending


func _ready() -> void:
	_attract.start_asked.connect(start_asked.emit)
	_language.chosen.connect(language_chosen.emit)
	_health.accepted.connect(health_accepted.emit)
	_choice.chosen.connect(content_chosen.emit)
	for page: MenuScreen in [_language, _health, _choice]:
		page.closed.connect(_on_closed)
	show_state(VisitDirector.State.ENDING)
	_ending.hide()


## Takes the settings over.
func configure(config: KioskConfig, headset: bool) -> void:
	_headset = headset
	_texts_wanted = config.flag("attract_texts") or on_board
	_languages = config.list("languages")
	_invitation = AttractScreen.BY_HEADSET if headset else AttractScreen.BY_BUTTON
	if on_board:
		_invitation = AttractScreen.BY_GAZE
	_language.offer(_languages)


## Shows the page of a step; none while the visitor is on the way.
func show_state(state: VisitDirector.State) -> void:
	_turning = true
	_attract.visible = state == VisitDirector.State.ATTRACT
	_ending.visible = state == VisitDirector.State.ENDING
	_turn(_language, state == VisitDirector.State.LANGUAGE)
	_turn(_health, state == VisitDirector.State.HEALTH)
	_turn(_choice, state == VisitDirector.State.CHOICE)
	_turning = false
	if _attract.visible and _texts_wanted:
		_attract.write(_languages, _invitation, on_board)
	elif _attract.visible:
		_attract.write_nothing()
	if _ending.visible:
		_ending.write(_headset)


func _turn(page: MenuScreen, shown: bool) -> void:
	if shown:
		page.open()
	else:
		page.close()


# By the visitor, not by show_state().
func _on_closed() -> void:
	if not _turning:
		back_asked.emit()
