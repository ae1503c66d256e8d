# SPDX-License-Identifier: MIT
extends SettingsCase
## Every setting does something, at once and after the next start, and leaves nothing behind.


func test_every_setting_has_an_effect() -> void:
	for key in SettingList.keys():
		assert_has(_effects._effects, key)
	assert_eq(_effects._effects.size(), SettingList.keys().size())


func test_quality() -> void:
	_settings.set_value(&"quality", "low")
	assert_eq(_sky.image_orders, 1)
	assert_almost_eq(_sky.magnitude_limit, 7.0, 1e-5)
	assert_almost_eq(get_viewport().scaling_3d_scale, 0.65, 1e-5)
	_settings.set_value(&"quality", "medium")
	assert_eq(_sky.image_orders, 2)
	assert_almost_eq(_sky.magnitude_limit, 8.5, 1e-5)
	assert_eq(get_viewport().scaling_3d_scale, 1.0)
	_settings.set_value(&"quality", "high")
	var initial: float = ClassDB.class_get_property_default_value(
		&"BlackHoleSky", &"magnitude_limit"
	)
	assert_almost_eq(_sky.magnitude_limit, initial, 1e-5)


func test_field_of_view() -> void:
	_settings.set_value(&"field_of_view", 50.0)
	assert_eq(_camera.fov, 50.0)


func test_frame_limit() -> void:
	_settings.set_value(&"frame_limit", "60")
	assert_eq(Engine.max_fps, 60)
	_settings.set_value(&"frame_limit", "none")
	assert_eq(Engine.max_fps, 0)


func test_sound() -> void:
	_settings.set_value(&"volume", 50.0)
	assert_almost_eq(AudioServer.get_bus_volume_db(0), -10.0, 0.01, "half as loud")
	_settings.set_value(&"volume", 0.0)
	assert_eq(AudioServer.get_bus_volume_db(0), SoundOutput.SILENCE)
	_settings.set_value(&"mute", true)
	assert_true(AudioServer.is_bus_mute(0))
	_settings.set_value(&"mono", true)
	_settings.set_value(&"mono", false)
	_settings.set_value(&"mono", true)
	assert_eq(AudioServer.get_bus_effect_count(0), 1)
	var narrow := AudioServer.get_bus_effect(0, 0) as AudioEffectStereoEnhance
	assert_eq(narrow.pan_pullout, 0.0)
	for key: StringName in [&"volume", &"mute", &"mono"]:
		_settings.set_value(key, SettingList.find(key).initial)
	assert_eq(AudioServer.get_bus_volume_db(0), 0.0)
	assert_false(AudioServer.is_bus_mute(0))
	assert_eq(AudioServer.get_bus_effect_count(0), 0)


func test_language() -> void:
	_settings.set_value(&"language", "de")
	assert_eq(TranslationServer.get_locale(), "de")
	_settings.set_value(&"language", "en")
	assert_eq(TranslationServer.get_locale(), "en")
	_settings.set_value(&"language", "system")
	assert_eq(TranslationServer.get_locale(), TranslationServer.standardize_locale(OS.get_locale()))


func test_size_of_text() -> void:
	var before := _theme.get_font_size(&"font_size", &"Caption")
	_settings.set_value(&"text_size", 150.0)
	assert_eq(_theme.get_font_size(&"font_size", &"Caption"), roundi(1.5 * before))
	assert_gt(_theme.default_font_size, 20)
	_settings.set_value(&"text_size", 100.0)
	assert_eq(_theme.get_font_size(&"font_size", &"Caption"), before)


func test_high_contrast() -> void:
	_settings.set_value(&"high_contrast", true)
	var panel := _theme.get_stylebox(&"panel", &"PanelContainer") as StyleBoxFlat
	assert_eq(panel.bg_color, Color.BLACK)
	assert_gt(panel.border_color.get_luminance() * panel.border_color.a, 0.6)
	assert_eq(_theme.get_color(&"font_color", &"Caption"), Color.WHITE)
	_settings.set_value(&"high_contrast", false)
	assert_ne(
		(_theme.get_stylebox(&"panel", &"PanelContainer") as StyleBoxFlat).bg_color, Color.BLACK
	)


func test_captions() -> void:
	_settings.set_value(&"captions", false)
	assert_false(_captions.captions_shown)
	_settings.set_value(&"caption_size", 150.0)
	assert_almost_eq(_captions.text_scale, 1.5, 1e-5)


func test_settings_count_from_the_start() -> void:
	remove_child(_effects)
	_effects.free()
	_settings.set_value(&"field_of_view", 90.0)
	_settings.set_value(&"invert_y", true)
	_camera.fov = 70.0
	_make_effects()
	assert_eq(_camera.fov, 90.0)
	assert_true(_controls.inverted)


func test_what_is_as_at_first_leaves_the_scene_alone() -> void:
	remove_child(_effects)
	_effects.free()
	_camera.fov = 33.0
	_sky.image_orders = 3
	TranslationServer.set_locale("de")
	_make_effects()
	assert_eq(_camera.fov, 33.0)
	assert_eq(_sky.image_orders, 3)
	assert_eq(TranslationServer.get_locale(), "de")


func test_nothing_stays_behind() -> void:
	_settings.set_value(&"mute", true)
	_settings.set_value(&"mono", true)
	_settings.set_value(&"frame_limit", "30")
	_settings.set_value(&"stick_dead_zone", 50.0)
	_settings.set_value(&"text_size", 150.0)
	_settings.set_value(&"bindings", {"toggle_flight": []})
	var size := THEME.default_font_size
	remove_child(_effects)
	assert_false(AudioServer.is_bus_mute(0))
	assert_eq(AudioServer.get_bus_effect_count(0), 0)
	assert_eq(Engine.max_fps, 0)
	assert_almost_eq(InputMap.action_get_deadzone(&"look_left"), 0.2, 1e-5)
	assert_gt(InputMap.action_get_events(&"toggle_flight").size(), 0)
	assert_eq(_theme.default_font_size, size)


func test_the_first_values_are_those_of_the_desktop_scene() -> void:
	var scene := load("res://scenes/desktop/desktop.tscn") as PackedScene
	var state := scene.get_state()
	var fov := -1.0
	for node in state.get_node_count():
		if state.get_node_name(node) == &"Camera":
			for property in state.get_node_property_count(node):
				if state.get_node_property_name(node, property) == &"fov":
					fov = state.get_node_property_value(node, property)
	assert_eq(SettingList.find(&"field_of_view").initial, fov)
	var zone: float = ProjectSettings.get_setting("input/look_left")["deadzone"]
	assert_almost_eq(zone * 100.0, 20.0, 1e-5)
	assert_eq(SettingList.find(&"stick_dead_zone").initial, 20.0)
