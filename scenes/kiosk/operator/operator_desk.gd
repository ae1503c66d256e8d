# SPDX-License-Identifier: MIT
class_name OperatorDesk
extends CanvasLayer
## Where the operator works: the PIN is asked for, then the panel opens. What concerns the whole
## exhibit is passed on.

signal reset_asked
signal leave_asked(status: int, why: String)
## Something for the log.
signal noted(text: String)
## The operator has the keys now, or no longer.
signal busy_changed

var config: KioskConfig
var content: ExhibitContent
var recorder: VisitRecorder

var _volume: float = 1.0

@onready var _pad: PinPad = $PinPad
@onready var _panel: OperatorPanel = $Panel


func _ready() -> void:
	_pad.passed.connect(_open_panel)
	for page: MenuScreen in [_pad, _panel]:
		page.visibility_changed.connect(busy_changed.emit)
	_panel.recentre_asked.connect(_on_recentre_asked)
	_panel.reset_asked.connect(reset_asked.emit)
	_panel.language_asked.connect(TranslationServer.set_locale)
	_panel.volume_asked.connect(take_volume)
	_panel.comfort_asked.connect(_on_comfort_asked)
	_panel.restart_asked.connect(leave_asked.emit.bind(ExitStatus.RESTART, "restart"))
	_panel.quit_asked.connect(leave_asked.emit.bind(ExitStatus.OPERATOR, "operator"))


## `facts` and `errors` are asked for what the panel shows.
func prepare(facts: Callable, errors: Callable) -> void:
	_pad.pin = config.get_pin()
	_panel.facts = facts
	_panel.errors = errors


func is_busy() -> bool:
	return _pad.visible or _panel.visible


## The operator has asked for the panel; a second time closes it.
func call_up() -> void:
	if _panel.visible:
		_panel.close()
	elif _pad.pin.is_set():
		_pad.open()
	else:
		_open_panel()


func take_volume(volume: float) -> void:
	_volume = volume
	AudioServer.set_bus_volume_linear(0, volume)


func _open_panel() -> void:
	noted.emit("the operator's panel is opened")
	_panel.offer(
		config.list("languages"), TranslationServer.get_locale(), _volume, content.get_comfort()
	)
	_panel.open()


func _on_recentre_asked() -> void:
	recorder.see_reset()
	content.recentre()


func _on_comfort_asked(preset: Comfort.Preset) -> void:
	content.get_comfort().preset = preset
