# SPDX-License-Identifier: MIT
class_name CardScreen
extends MenuScreen
## The physics cards: a list at the left, at the right the card that is chosen in it, with what it
## says of the place where the eye is.

const BUTTON: StringName = &"CardItem"
## Beside the card that is shown, also when the focus has gone on.
const BUTTON_SHOWN: StringName = &"CardItemShown"
const FORMULA_PIXELS: int = 30
const FORMULA_COLOUR := Color(0.86, 0.93, 1.0)
## Seconds between two looks at the place.
const INTERVAL: float = 0.25

@export var card_set: PhysicsCardSet = preload("res://scenes/cards/cards.tres")
@export var sky: BlackHoleSky
@export var camera: Camera3D
@export var disk: AccretionDisk

var _figures := PlaceFigures.new()
var _buttons: Array[Button] = []
var _shown: int = 0
var _elapsed: float = 0.0

@onready var _list: VBoxContainer = %List
@onready var _scroll: ScrollContainer = %CardScroll
@onready var _title: Label = %CardTitle
@onready var _text: Label = %CardText
@onready var _formulas: VBoxContainer = %Formulas
@onready var _legend: Label = %Legend
@onready var _here: Label = %Here
@onready var _close: Button = %Close


func _ready() -> void:
	_figures.sky = sky
	_figures.camera = camera
	_figures.disk = disk
	_close.pressed.connect(close)
	for i in card_set.cards.size():
		_add_button(card_set.cards[i].title, i)
	_chain_focus()
	show_card(0)


func _process(delta: float) -> void:
	_elapsed += delta
	if visible and _elapsed >= INTERVAL:
		_tell_here()


## Shows a card by its number in the list.
func show_card(index: int) -> void:
	_shown = clampi(index, 0, card_set.cards.size() - 1)
	var card := card_set.cards[_shown]
	_title.text = card.title
	_text.text = card.text
	_legend.text = card.legend
	for shown in _formulas.get_children():
		shown.free()
	for formula in card.formulas:
		var label := FormulaLabel.new()
		label.font_size = FORMULA_PIXELS
		label.colour = FORMULA_COLOUR
		label.formula = formula
		_formulas.add_child(label)
	for i in _buttons.size():
		_buttons[i].theme_type_variation = BUTTON_SHOWN if i == _shown else BUTTON
	_scroll.scroll_vertical = 0
	_tell_here()


func get_shown() -> int:
	return _shown


## The one that was shown last.
func get_first_focus() -> Control:
	return _buttons[_shown]


func _on_open() -> void:
	_tell_here()


func _tell_here() -> void:
	_elapsed = 0.0
	var line := _figures.line(card_set.cards[_shown].figure)
	_here.text = line
	_here.visible = not line.is_empty()


func _add_button(title: String, index: int) -> void:
	var button := Button.new()
	button.text = title
	button.theme_type_variation = BUTTON
	button.alignment = HORIZONTAL_ALIGNMENT_LEFT
	button.focus_entered.connect(show_card.bind(index))
	_list.add_child(button)
	_buttons.append(button)


# Up and down go through the list and round; to the sides there is nothing.
func _chain_focus() -> void:
	var chain: Array[Control] = []
	chain.assign(_buttons)
	chain.append(_close)
	FocusRing.link(chain)
	for control in chain:
		control.focus_neighbor_left = NodePath(".")
		control.focus_neighbor_right = NodePath(".")
