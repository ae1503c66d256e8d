# SPDX-License-Identifier: MIT
extends "res://tests/integration/desktop_test.gd"
## The panel: by keyboard alone, by gamepad alone, and what it switches.

var _panel: SkyPanel
var _rides: RideDirector


func before_each() -> void:
	super()
	_panel = _scene.get_node("%Panel")
	_rides = _scene.get_node("Rides")
	_rides.set_process(false)


func _box(box_name: String) -> CheckBox:
	return _panel.get_node("%" + box_name)


func _focused() -> Control:
	return get_tree().root.gui_get_focus_owner()


# From the tabs to the ride in the given row, with four buttons that mean right, down, yes.
func _start_ride(right: InputEvent, down: InputEvent, accept: InputEvent) -> void:
	await wait_process_frames(2)
	_press(right)
	await wait_process_frames(2)
	_press(right)
	await wait_process_frames(2)
	_press(down)
	_press(down)
	assert_true(_focused() is Button)
	_press(accept)


func test_by_keyboard_alone() -> void:
	_press(_key_event(KEY_P))
	assert_true(_panel.visible)
	await _start_ride(_key_event(KEY_RIGHT), _key_event(KEY_DOWN), _key_event(KEY_ENTER))
	assert_true(_rides.is_on())
	assert_string_contains(_rides.ride.get_title(), "infinity")
	assert_false(_panel.visible, "it makes room for the ride")
	assert_almost_eq(_controls.rig.get_distance(), 30.0, 1e-4)


func test_by_gamepad_alone() -> void:
	_press(_button_event(JOY_BUTTON_BACK))
	assert_true(_panel.visible)
	await _start_ride(
		_button_event(JOY_BUTTON_DPAD_RIGHT),
		_button_event(JOY_BUTTON_DPAD_DOWN),
		_button_event(JOY_BUTTON_A)
	)
	assert_true(_rides.is_on())
	_press(_button_event(JOY_BUTTON_BACK))
	assert_true(_panel.visible)
	var exposure := _sky.exposure
	_press(_button_event(JOY_BUTTON_DPAD_UP))
	assert_eq(_sky.exposure, exposure, "the pad is the panel's")
	_press(_button_event(JOY_BUTTON_B))
	assert_false(_panel.visible)
	assert_true(_rides.is_on(), "closed, not left")


func test_the_arrow_down_alone_comes_by_every_control() -> void:
	_panel.toggle()
	var tabs: TabContainer = _panel.get_node("%Tabs")
	for tab in tabs.get_tab_count():
		tabs.current_tab = tab
		tabs.get_tab_bar().grab_focus()
		await wait_process_frames(2)
		var missing: Array[Node] = []
		for node in tabs.get_current_tab_control().find_children("*", "Control", true, false):
			var control := node as Control
			var button := control as BaseButton
			if control.focus_mode == Control.FOCUS_ALL and (button == null or not button.disabled):
				missing.append(control)
		assert_gt(missing.size(), 5)
		for step in missing.size():
			_press(_key_event(KEY_DOWN))
			missing.erase(_focused())
			await wait_process_frames(1)
		assert_eq(missing, [] as Array[Node], "page %d" % tab)


func test_keys_that_go_through_the_panel_do_not_steer() -> void:
	_panel.toggle()
	_hold(_key_event(KEY_RIGHT))
	_let_pass(0.5)
	_hold(_key_event(KEY_RIGHT, false))
	assert_almost_eq(_controls.rig.get_distance(), StartView.DISTANCE, 1e-4)
	var place := _controls.rig.get_position()
	_panel.toggle()
	_let_pass(0.5)
	assert_almost_eq(_controls.rig.get_position(), place, Vector3.ONE * 1e-4)
	_hold(_key_event(KEY_RIGHT))
	_let_pass(0.5)
	_hold(_key_event(KEY_RIGHT, false))
	assert_gt(_controls.rig.get_position().distance_to(place), 1.0, "and do again")


func test_each_switch_is_its_effect() -> void:
	_panel.toggle()
	var switches: Dictionary[String, String] = {
		"Deflection": "effect_deflection",
		"Aberration": "effect_aberration",
		"Gravitational": "effect_gravitational_shift",
		"Doppler": "effect_doppler",
		"Magnification": "effect_magnification",
		"HigherOrders": "effect_higher_orders",
		"RedshiftMap": "redshift_map",
	}
	for box_name in switches:
		var before: bool = _sky.get(switches[box_name])
		assert_eq(_box(box_name).button_pressed, before, box_name)
		_box(box_name).button_pressed = not before
		for other in switches:
			var expected: bool = other != "RedshiftMap"
			if other == box_name:
				expected = not before
			assert_eq(_sky.get(switches[other]), expected, "%s, %s" % [box_name, other])
		_box(box_name).button_pressed = before


func test_inside_the_horizon_effects_go_in_pairs_and_it_says_why() -> void:
	_panel.toggle()
	var reason: Label = _panel.get_node("%Reason")
	assert_false(reason.visible)
	_sky.effect_aberration = false
	_controls.rig.place(Vector3(0.0, 0.0, 0.8), Quaternion.IDENTITY)
	_panel.refresh()
	assert_true(reason.visible)
	assert_false(_box("Aberration").visible)
	assert_false(_box("Doppler").visible)
	assert_true(_box("Deflection").button_pressed, "one of the two is on")
	_box("Deflection").button_pressed = false
	assert_false(_sky.effect_deflection or _sky.effect_aberration)
	_box("Deflection").button_pressed = true
	assert_true(_sky.effect_deflection and _sky.effect_aberration)
	_box("Gravitational").button_pressed = false
	assert_false(_sky.effect_gravitational_shift or _sky.effect_doppler)


func test_observer_mass_and_saturation() -> void:
	_panel.toggle()
	var options := _panel.get_node("%ObserverList").get_children()
	assert_eq(options.size(), ObserverKind.Kind.size())
	(options[ObserverKind.Kind.ORBIT_LEFT] as CheckBox).pressed.emit()
	assert_eq(_sky.observer_motion, LensingTable.MOTION_ORBIT)
	(options[ObserverKind.Kind.RISING] as CheckBox).pressed.emit()
	assert_true(_sky.observer.outgoing)
	(_panel.get_node("%Energy") as HSlider).value = 2.0
	assert_almost_eq(_sky.observer.energy, 2.0, 1e-6, "follows at once")
	(_panel.get_node("%MassList").get_child(1) as CheckBox).pressed.emit()
	assert_almost_eq(_sky.mass_solar, 4.3e6, 1.0)
	(_panel.get_node("%Saturation") as HSlider).value = 2.5
	assert_almost_eq(_sky.saturation, 2.5, 1e-6)


func test_the_exposure_adapts_when_asked_to() -> void:
	_panel.toggle()
	assert_false(_sky.auto_exposure)
	_box("Adapting").button_pressed = true
	assert_true(_sky.auto_exposure)
	var readouts: Readouts = _scene.get_node("%Readouts")
	readouts.update()
	assert_string_contains((readouts.get_node("%Picture") as Label).text, "auto")
	_sky.adapt_at_once()
	var ev := _sky.get_effective_exposure()
	assert_almost_eq(ev, _sky.exposure, 1.0, "the first view is near the key")
	_box("Adapting").button_pressed = false
	assert_eq(_sky.get_effective_exposure(), _sky.exposure)


func test_the_legend_is_there_while_the_map_is() -> void:
	var legend: Control = _scene.get_node("%Legend")
	await wait_process_frames(2)
	assert_false(legend.visible)
	_sky.redshift_map = true
	await wait_process_frames(2)
	assert_true(legend.visible)
