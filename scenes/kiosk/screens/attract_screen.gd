# SPDX-License-Identifier: MIT
class_name AttractScreen
extends Control
## The words over the pictures that call visitors: a title, and what to do, in every language.

## In the headset there is a button to look at.
signal start_asked

const TITLE: String = "The sky at a black hole"
const LINE: String = "Every star and every bend of light is computed, not filmed."
const BY_HEADSET: String = "Put on the headset to begin."
const BY_BUTTON: String = "Press any button to begin."
const BY_GAZE: String = "Look at the button to begin."
## One breath of the invitation, seconds, and how faint it becomes.
const BREATH_SECONDS: float = 4.0
const FAINTEST: float = 0.72

var _seconds: float = 0.0

@onready var _words: Control = %Words
@onready var _rows: Control = %Rows
@onready var _lines: VBoxContainer = %Lines
@onready var _invitations: VBoxContainer = %Invitations
@onready var _start: Button = %Start


func _ready() -> void:
	_start.pressed.connect(start_asked.emit)


func _process(delta: float) -> void:
	_seconds = fmod(_seconds + delta, BREATH_SECONDS)
	var breath := 0.5 + 0.5 * cos(TAU * _seconds / BREATH_SECONDS)
	_invitations.modulate.a = lerpf(FAINTEST, 1.0, breath)


## Writes the words in these languages, and what begins a visit; `board`: on the sign in the
## headset, which has a button.
func write(languages: PackedStringArray, invitation: String, board: bool) -> void:
	for old: Node in _lines.get_children() + _invitations.get_children():
		old.free()
	for i in languages.size():
		var title := _label(
			TextIn.language(TITLE, languages[i]), &"HelpTitle", 46 if i == 0 else 26
		)
		_lines.add_child(title)
		var invited := TextIn.language(invitation, languages[i])
		_invitations.add_child(_label(invited, &"Label", 24))
	if languages.size() > 0:
		_lines.add_child(_label(TextIn.language(LINE, languages[0]), &"Label", 18))
	_rows.anchor_right = 0.94 if board else 0.5
	_start.visible = board
	_start.text = TextIn.language("Begin", languages[0]) if languages.size() > 0 else "Begin"
	set_process(not board)
	_words.visible = true


## Takes the words away, where only the pictures are to call.
func write_nothing() -> void:
	_words.visible = false


func get_first_focus() -> Control:
	return _start if _start.visible else null


func _label(text: String, kind: StringName, pixels: int) -> Label:
	var label := Label.new()
	label.text = text
	label.auto_translate_mode = Node.AUTO_TRANSLATE_MODE_DISABLED
	label.theme_type_variation = kind
	label.autowrap_mode = TextServer.AUTOWRAP_WORD_SMART
	label.add_theme_font_size_override(&"font_size", pixels)
	return label
