# SPDX-License-Identifier: MIT
class_name BindingCapture
extends CenterContainer
## Waits for a key or a button that an action is to have; everything else waits meanwhile.

signal captured(event: InputEvent)
signal given_up

## Seconds until it gives up by itself.
const PATIENCE: float = 5.0
## So far a stick must be pushed to be meant.
const FAR: float = 0.6

var _device: InputBindings.Device
var _left: float = 0.0
var _title: Label = Label.new()
var _asked: Label = Label.new()
var _way_out: Label = Label.new()


func _init() -> void:
	hide()
	set_anchors_preset(Control.PRESET_FULL_RECT)
	mouse_filter = Control.MOUSE_FILTER_STOP
	var panel := PanelContainer.new()
	panel.theme_type_variation = &"NoticePanel"
	add_child(panel)
	var lines := VBoxContainer.new()
	lines.add_theme_constant_override(&"separation", 8)
	panel.add_child(lines)
	_asked.theme_type_variation = &"HelpTitle"
	_way_out.theme_type_variation = &"Caption"
	for label: Label in [_title, _asked, _way_out]:
		label.horizontal_alignment = HORIZONTAL_ALIGNMENT_CENTER
		label.auto_translate_mode = Node.AUTO_TRANSLATE_MODE_DISABLED
		lines.add_child(label)


func _process(delta: float) -> void:
	if not visible:
		return
	_left -= delta
	_way_out.text = tr("Escape: leave it as it is (%d s)") % ceili(maxf(_left, 0.0))
	if _left <= 0.0:
		_give_up()


func _input(event: InputEvent) -> void:
	if not visible:
		return
	get_viewport().set_input_as_handled()
	if event is InputEventKey and _is_press(event) and _key(event) == KEY_ESCAPE:
		_give_up()
	elif _is_press(event) and _is_of_device(event):
		hide()
		captured.emit(event)
	elif event is InputEventMouseButton and event.is_pressed():
		_give_up()


## Asks for an event of this device for an action.
func ask(action: StringName, device: InputBindings.Device) -> void:
	_device = device
	_left = PATIENCE
	_title.text = tr(ActionList.title_of(action))
	_asked.text = asked_words(device)
	show()


## What is asked for.
static func asked_words(device: InputBindings.Device) -> String:
	match device:
		InputBindings.Device.MOUSE:
			return _translated("Press the mouse's middle or side button")
		InputBindings.Device.GAMEPAD:
			return _translated("Press a button or move a stick")
	return _translated("Press a key")


func _give_up() -> void:
	hide()
	given_up.emit()


func _is_press(event: InputEvent) -> bool:
	if event is InputEventJoypadMotion:
		return absf((event as InputEventJoypadMotion).axis_value) >= FAR
	return event.is_pressed() and not event.is_echo()


func _is_of_device(event: InputEvent) -> bool:
	var words := BindingText.of(event)
	return not words.is_empty() and InputBindings.device_of(words) == _device


func _key(event: InputEvent) -> Key:
	var pressed := event as InputEventKey
	return pressed.keycode if pressed.physical_keycode == KEY_NONE else pressed.physical_keycode


static func _translated(text: String) -> String:
	return TranslationServer.translate(text)
