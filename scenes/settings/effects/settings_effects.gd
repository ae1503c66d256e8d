# SPDX-License-Identifier: MIT
class_name SettingsEffects
extends Node
## Lets the settings count: at the start those that are not as at first, so that scenes and command
## line keep their say, later each one that changes.

## Time of the disk in a second, in light travel times of a Schwarzschild radius, with less motion.
const GENTLE_DISK: float = 2.0
## These outlive the scene unless they are taken back.
const LASTING: Array[StringName] = [
	&"vsync",
	&"frame_limit",
	&"volume",
	&"mute",
	&"mono",
	&"stick_dead_zone",
	&"bindings",
]

@export var settings: UserSettings
@export var sky: BlackHoleSky
@export var camera: Camera3D
@export var controls: ViewControls
@export var switches: SkySwitches
@export var disk_clock: DiskClock
## May be missing, where there is no tour.
@export var captions: TourCaptions
@export var themes: Array[Theme]

var _effects: Dictionary[StringName, Callable] = {
	&"quality": _apply_quality,
	&"field_of_view": _apply_field_of_view,
	&"fullscreen": _apply_fullscreen,
	&"vsync": _apply_vsync,
	&"frame_limit": _apply_frame_limit,
	&"volume": SoundOutput.set_volume,
	&"mute": SoundOutput.set_mute,
	&"mono": SoundOutput.set_mono,
	&"mouse_sensitivity": _apply_mouse_sensitivity,
	&"stick_sensitivity": _apply_stick_sensitivity,
	&"stick_dead_zone": _apply_dead_zone,
	&"invert_y": _apply_inversion,
	&"fast_mode": _apply_fast_mode,
	&"bindings": _apply_bindings,
	&"language": _apply_language,
	&"text_size": _apply_theme,
	&"high_contrast": _apply_theme,
	&"reduced_motion": _apply_reduced_motion,
	&"captions": _apply_captions,
	&"caption_size": _apply_caption_size,
}
var _variants: Array[ThemeVariant] = []
var _disk_rate: float


func _ready() -> void:
	for theme in themes:
		_variants.append(ThemeVariant.new(theme))
	_disk_rate = disk_clock.rate
	for key in _effects:
		if not settings.is_initial(key):
			_effects[key].call(settings.get_value(key))
	settings.changed.connect(_on_changed)


func _exit_tree() -> void:
	settings.changed.disconnect(_on_changed)
	for key in LASTING:
		if not settings.is_initial(key):
			_effects[key].call(SettingList.find(key).initial)
	for variant in _variants:
		variant.apply(1.0, false)


func _on_changed(key: StringName) -> void:
	_effects[key].call(settings.get_value(key))


func _apply_quality(level: String) -> void:
	PictureQuality.apply(level, sky, get_viewport())


func _apply_field_of_view(degrees: float) -> void:
	camera.fov = degrees


func _apply_fullscreen(wanted: bool) -> void:
	var window := get_window()
	var full := window.mode in [Window.MODE_FULLSCREEN, Window.MODE_EXCLUSIVE_FULLSCREEN]
	if full != wanted:
		window.mode = Window.MODE_FULLSCREEN if wanted else Window.MODE_WINDOWED


func _apply_vsync(wanted: bool) -> void:
	DisplayServer.window_set_vsync_mode(
		DisplayServer.VSYNC_ENABLED if wanted else DisplayServer.VSYNC_DISABLED,
		get_window().get_window_id()
	)


func _apply_frame_limit(limit: String) -> void:
	Engine.max_fps = limit.to_int()


func _apply_mouse_sensitivity(percent: float) -> void:
	controls.mouse_sensitivity = percent / 100.0


func _apply_stick_sensitivity(percent: float) -> void:
	controls.steering_sensitivity = percent / 100.0


func _apply_dead_zone(percent: float) -> void:
	for action in ActionList.actions():
		InputMap.action_set_deadzone(action, percent / 100.0)


func _apply_inversion(wanted: bool) -> void:
	controls.inverted = wanted


func _apply_fast_mode(mode: String) -> void:
	controls.fast_toggles = mode == "toggle"


func _apply_bindings(changes: Dictionary) -> void:
	InputBindings.from_json(changes, []).apply()


func _apply_language(wanted: String) -> void:
	var system := wanted == SettingList.SYSTEM_LANGUAGE
	TranslationServer.set_locale(OS.get_locale() if system else wanted)


func _apply_theme(_value: Variant) -> void:
	for variant in _variants:
		variant.apply(settings.get_number(&"text_size") / 100.0, settings.is_on(&"high_contrast"))


func _apply_reduced_motion(wanted: bool) -> void:
	controls.eased = not wanted
	switches.gradual = not wanted
	disk_clock.rate = minf(_disk_rate, GENTLE_DISK) if wanted else _disk_rate


func _apply_captions(shown: bool) -> void:
	if captions != null:
		captions.captions_shown = shown


func _apply_caption_size(percent: float) -> void:
	if captions != null:
		captions.text_scale = percent / 100.0
