# SPDX-License-Identifier: MIT
class_name SimulatedVisitors
extends Node
## Visitors that do not exist, for tests: after -- --simulated-visitors=SEED they press keys and
## buttons at random, as events of devices, try to leave the program, and walk away.

const ARGUMENT: String = "--simulated-visitors="
## Between two presses, seconds.
const EVERY_SECONDS: float = 0.12
## Of all visitors so many walk away without a word.
const WALKING_AWAY: float = 0.3
const KEYS: Array[Key] = [
	KEY_ENTER,
	KEY_UP,
	KEY_DOWN,
	KEY_LEFT,
	KEY_RIGHT,
	KEY_TAB,
	KEY_P,
	KEY_B,
	KEY_N,
	KEY_T,
	KEY_V,
	KEY_M,
	KEY_O,
	KEY_L,
	KEY_W,
	KEY_S,
	KEY_HOME,
	KEY_X,
]
const BUTTONS: Array[JoyButton] = [
	JOY_BUTTON_A,
	JOY_BUTTON_A,
	JOY_BUTTON_B,
	JOY_BUTTON_X,
	JOY_BUTTON_Y,
	JOY_BUTTON_BACK,
	JOY_BUTTON_START,
	JOY_BUTTON_DPAD_UP,
	JOY_BUTTON_DPAD_DOWN,
	JOY_BUTTON_DPAD_LEFT,
	JOY_BUTTON_DPAD_RIGHT,
]
## What ends other programs.
const WAYS_OUT: Array[Key] = [KEY_ESCAPE, KEY_F4, KEY_F11, KEY_Q, KEY_W, KEY_F8]

@export var kiosk: Kiosk

var _random := RandomNumberGenerator.new()
var _since: float = 0.0
var _is_away: bool = false


func _ready() -> void:
	set_process(false)
	var chosen := CommandLine.value(CommandLine.of_program(), ARGUMENT)
	if not chosen.is_empty():
		# Another start, other visitors.
		_random.seed = hash([chosen, OS.get_process_id()])
		set_process(true)
	kiosk.director.visit_begun.connect(_on_visit_begun)


func _process(delta: float) -> void:
	_since += delta
	if _since < EVERY_SECONDS or not kiosk.director.is_ready:
		return
	_since = 0.0
	match kiosk.director.state:
		VisitDirector.State.ATTRACT:
			_press(JOY_BUTTON_A)
		VisitDirector.State.LANGUAGE, VisitDirector.State.HEALTH, VisitDirector.State.CHOICE:
			_choose()
		_:
			_play()


func _on_visit_begun(_by: StringName) -> void:
	_is_away = false


func _choose() -> void:
	if _is_away:
		return
	_is_away = _random.randf() < 0.01
	if _random.randf() < 0.6:
		_press(JOY_BUTTON_A)
	else:
		_press(BUTTONS[_random.randi() % BUTTONS.size()])


func _play() -> void:
	if _is_away:
		return
	_is_away = _random.randf() < 0.02 * WALKING_AWAY
	var what := _random.randf()
	if what < 0.12:
		_try_to_leave()
	elif what < 0.5:
		_press(BUTTONS[_random.randi() % BUTTONS.size()])
	else:
		_strike(KEYS[_random.randi() % KEYS.size()])


func _try_to_leave() -> void:
	if _random.randf() < 0.2:
		get_tree().root.propagate_notification(NOTIFICATION_WM_CLOSE_REQUEST)
		return
	var key := WAYS_OUT[_random.randi() % WAYS_OUT.size()]
	_strike(key, key == KEY_F4, key == KEY_Q or key == KEY_W)
	# Twice is what asks for the end where once only shows the way.
	_strike(key, key == KEY_F4, key == KEY_Q or key == KEY_W)


func _press(button: JoyButton) -> void:
	var event := InputEventJoypadButton.new()
	event.button_index = button
	_send(event)


func _strike(key: Key, alt: bool = false, ctrl: bool = false) -> void:
	var event := InputEventKey.new()
	event.keycode = key
	event.physical_keycode = key
	event.alt_pressed = alt
	event.ctrl_pressed = ctrl
	_send(event)


func _send(event: InputEvent) -> void:
	for pressed: bool in [true, false]:
		var sent := event.duplicate() as InputEvent
		sent.set("pressed", pressed)
		Input.parse_input_event(sent)
