# SPDX-License-Identifier: MIT
extends "res://tests/integration/desktop_test.gd"
## The desktop scene answers keys and buttons, and its display says what is.

var _switching: Array = (
	ParameterFactory
	. named_parameters(
		["key", "button", "property"],
		[
			[KEY_O, JOY_BUTTON_X, "observer_motion"],
			[KEY_B, JOY_BUTTON_Y, "background"],
			[KEY_I, JOY_BUTTON_DPAD_RIGHT, "image_orders"],
			[KEY_PLUS, JOY_BUTTON_DPAD_UP, "exposure"],
			[KEY_MINUS, JOY_BUTTON_DPAD_DOWN, "exposure"],
		]
	)
)


func _press_key(key: Key) -> void:
	get_tree().root.push_input(_key_event(key))
	get_tree().root.push_input(_key_event(key, false))


func _press_button(button: JoyButton) -> void:
	get_tree().root.push_input(_button_event(button))
	get_tree().root.push_input(_button_event(button, false))


func _text(label_name: String) -> String:
	(_scene.get_node("%Readouts") as Readouts).update()
	return (_scene.get_node("%Readouts").get_node("%" + label_name) as Label).text


func test_starts_with_hole_table_and_stars() -> void:
	assert_true(_sky.table.is_ready(), "the table")
	assert_gt(_sky.catalogue.get_star_count(), 100000, "the stars")
	assert_almost_eq(_controls.rig.get_distance(), StartView.DISTANCE, 1e-4)
	var camera: Camera3D = _scene.get_node("Camera")
	assert_almost_eq(camera.global_position.length(), StartView.DISTANCE, 1e-4)


func test_the_display_says_what_is() -> void:
	assert_eq(_text("Distance"), "12.00 rₛ")
	assert_string_contains(_text("Observer"), "static")
	var angle := LensingTable.shadow_angle(StartView.DISTANCE, LensingTable.MOTION_STATIC)
	assert_string_contains(_text("Shadow"), "%.2f°" % rad_to_deg(angle))
	assert_string_contains(_text("Picture"), "2 image orders")
	assert_string_contains(_text("Motion"), "orbit")
	assert_string_ends_with(_text("Frames"), "per second")


func test_the_display_knows_the_inside_and_a_sky_without_hole() -> void:
	_controls.rig.place(Vector3(0.0, 0.0, 0.5), Quaternion.IDENTITY)
	await wait_process_frames(2)
	assert_string_contains(_text("Observer"), "rain")
	assert_string_contains(_notices.get_text(ObserverChoice.TOPIC), "horizon")
	var inside: Label = _scene.get_node("%Readouts").get_node("%Inside")
	assert_true(inside.visible)
	_sky.lensing = 0.0
	assert_string_starts_with(_text("Shadow"), ReadoutText.NOTHING)
	assert_false(inside.visible)


func test_keys_and_buttons_switch_the_sky(p: Variant = use_parameters(_switching)) -> void:
	var property: String = p.property
	var before: Variant = _sky.get(property)
	var key: Key = p.key
	var button: JoyButton = p.button
	_press_key(key)
	var after_key: Variant = _sky.get(property)
	assert_ne(after_key, before, "key %s switches %s" % [p.key, property])
	_press_button(button)
	assert_ne(_sky.get(property), after_key, "button %s switches %s" % [p.button, property])


func test_key_and_button_take_the_hole_away_and_bring_it_back() -> void:
	var switches: SkySwitches = _scene.get_node("Switches")
	_press_key(KEY_L)
	assert_false(switches.is_hole_wanted())
	_press_button(JOY_BUTTON_B)
	assert_true(switches.is_hole_wanted())


func test_a_held_key_repeats_exposure_alone() -> void:
	var exposure := _sky.exposure
	var orders := _sky.image_orders
	for key: Key in [KEY_PLUS, KEY_I]:
		for i in 3:
			var event := _key_event(key)
			event.echo = i > 0
			get_tree().root.push_input(event)
	assert_almost_eq(_sky.exposure, exposure + 3.0 * SkySwitches.EXPOSURE_STEP, 1e-5)
	assert_eq(_sky.image_orders, orders + 1)


func test_static_is_refused_by_key_inside_the_horizon() -> void:
	_sky.observer_motion = LensingTable.MOTION_RAIN
	_controls.rig.place(Vector3(0.0, 0.7, 0.0), Quaternion.IDENTITY)
	_press_key(KEY_O)
	assert_eq(_sky.observer_motion, LensingTable.MOTION_RAIN)
	assert_string_contains(_notices.get_text(ObserverChoice.TOPIC), "horizon")


func test_the_display_is_hidden_and_shown() -> void:
	var readouts: Control = _scene.get_node("%Readouts")
	_press_key(KEY_TAB)
	assert_false(readouts.visible)
	_press_button(JOY_BUTTON_DPAD_LEFT)
	assert_true(readouts.visible)


func test_help_opens_and_holds_the_rest_back() -> void:
	_press_key(KEY_F1)
	assert_true(_help.visible)
	var orders := _sky.image_orders
	_press_key(KEY_I)
	assert_eq(_sky.image_orders, orders, "other keys rest")
	_hold(_key_event(KEY_W))
	_let_pass(0.5)
	assert_almost_eq(_controls.rig.get_distance(), StartView.DISTANCE, 1e-4, "the eye rests")
	_press_key(KEY_F1)
	assert_false(_help.visible)
	_press_key(KEY_F1)
	_press_button(JOY_BUTTON_B)
	assert_false(_help.visible, "closed by the button that means no")


func test_help_names_keys_and_buttons() -> void:
	_help.open()
	var texts := PackedStringArray()
	for label: Label in _help.find_children("*", "Label", true, false):
		texts.append(label.text)
	for expected: String in [
		"W   A   S   D", "Right stick", "D-pad left", "Escape", "Page Up   Page Down"
	]:
		assert_true("\n".join(texts).contains(expected), expected)


func test_flight_is_switched_and_the_view_reset() -> void:
	watch_signals(_controls)
	_press_key(KEY_F)
	assert_eq(_controls.mode, ViewControls.Mode.FLIGHT)
	_press_button(JOY_BUTTON_A)
	assert_eq(_controls.mode, ViewControls.Mode.ORBIT)
	assert_signal_emit_count(_controls, "mode_changed", 2)
	_press_key(KEY_F)
	_controls.rig.place(Vector3(50.0, 3.0, 1.0), Quaternion.IDENTITY)
	_press_key(KEY_HOME)
	assert_eq(_controls.mode, ViewControls.Mode.ORBIT)
	assert_almost_eq(_controls.rig.get_distance(), StartView.DISTANCE, 1e-4)


func test_german() -> void:
	TranslationServer.set_locale("de")
	assert_string_contains(_text("Observer"), "statisch")
	assert_string_contains(_text("Picture"), "Bildordnungen")
	TranslationServer.set_locale("en")
	assert_string_contains(_text("Observer"), "static")
