# SPDX-License-Identifier: MIT
extends GutTest
## Sets the desktop scene up for a test and makes the events that keyboard and gamepad send.

const SCENE: PackedScene = preload("res://scenes/desktop/desktop.tscn")

var _locale: String
var _scene: DesktopScene
var _sky: BlackHoleSky
var _controls: ViewControls
var _help: HelpOverlay
var _notices: NoticeBoard


func before_all() -> void:
	_locale = TranslationServer.get_locale()
	TranslationServer.set_locale("en")


func after_all() -> void:
	TranslationServer.set_locale(_locale)


func before_each() -> void:
	_scene = SCENE.instantiate() as DesktopScene
	add_child_autofree(_scene)
	_sky = _scene.get_node("Sky")
	_controls = _scene.get_node("Controls")
	_help = _scene.get_node("%Help")
	_notices = _scene.get_node("%Notices")
	# Time passes only where a test lets it pass.
	_controls.set_process(false)


func after_each() -> void:
	for action in InputMap.get_actions():
		Input.action_release(action)


func _key_event(key: Key, pressed: bool = true) -> InputEventKey:
	return DeviceInput.key(key, pressed)


func _button_event(button: JoyButton, pressed: bool = true) -> InputEventJoypadButton:
	return DeviceInput.button(button, pressed)


# What the polled state of the input sees.
func _hold(event: InputEvent) -> void:
	DeviceInput.send(event)


# And lets go of it.
func _press(event: InputEvent) -> void:
	DeviceInput.press(event)


func _let_pass(seconds: float) -> void:
	for i in ceili(seconds * 50.0):
		_controls.advance(0.02)
