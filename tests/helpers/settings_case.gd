# SPDX-License-Identifier: MIT
class_name SettingsCase
extends GutTest
## Settings with all that they have an effect on, without a picture.

const THEME: Theme = preload("res://scenes/desktop/hud/hud_theme.tres")

var _settings: UserSettings
var _effects: SettingsEffects
var _sky: BlackHoleSky
var _camera: Camera3D
var _controls: ViewControls
var _switches: SkySwitches
var _clock: DiskClock
var _captions: TourCaptions
var _theme: Theme
var _locale: String


func before_each() -> void:
	_locale = TranslationServer.get_locale()
	_settings = UserSettings.new()
	_settings.file = ""
	add_child_autofree(_settings)
	_sky = BlackHoleSky.new()
	_camera = Camera3D.new()
	_camera.fov = 70.0
	_controls = ViewControls.new()
	_controls.camera = _camera
	_controls.sky = _sky
	_controls.set_process(false)
	_switches = SkySwitches.new()
	_switches.sky = _sky
	_clock = DiskClock.new()
	_clock.set_process(false)
	_captions = TourCaptions.new()
	_theme = THEME.duplicate(true) as Theme
	for node: Node in [_sky, _camera, _switches, _clock]:
		add_child_autofree(node)
	_controls.set_process(false)
	add_child_autofree(_controls)
	autofree(_captions)
	_make_effects()


func after_each() -> void:
	if _effects.is_inside_tree():
		remove_child(_effects)
	_effects.free()
	for action in InputMap.get_actions():
		Input.action_release(action)
	TranslationServer.set_locale(_locale)
	get_viewport().scaling_3d_scale = 1.0


func _make_effects() -> void:
	_effects = SettingsEffects.new()
	_effects.settings = _settings
	_effects.sky = _sky
	_effects.camera = _camera
	_effects.controls = _controls
	_effects.switches = _switches
	_effects.disk_clock = _clock
	_effects.captions = _captions
	_effects.themes = [_theme]
	add_child(_effects)
