# SPDX-License-Identifier: MIT
extends "res://tests/integration/desktop_test.gd"
## Everything fits into a window of 1280 x 720, in every language and with the longest numbers.

const WINDOW: Vector2 = Vector2(1280.0, 720.0)

var _locales: Array = ParameterFactory.named_parameters(["locale"], [["en"], ["de"]])


func after_each() -> void:
	super()
	TranslationServer.set_locale("en")


func _assert_fits(control: Control, what: String) -> void:
	var needed := control.get_combined_minimum_size()
	assert_lte(needed.x, WINDOW.x, "%s is %s wide" % [what, needed.x])
	assert_lte(needed.y, WINDOW.y, "%s is %s high" % [what, needed.y])


func test_display_bar_and_panel_fit(p: Variant = use_parameters(_locales)) -> void:
	TranslationServer.set_locale(p.locale)
	var rides: RideDirector = _scene.get_node("Rides")
	rides.set_process(false)
	var panel: SkyPanel = _scene.get_node("%Panel")
	panel.toggle()
	_sky.mass_solar = ObserverPage.MASSES[-1]
	for kind: RideDirector.Kind in RideDirector.Kind.values():
		_controls.rig.look_from(Vector3(0.0, 0.0, 12.345), Vector3.UP)
		assert_true(rides.start(kind))
		rides.seek(1.0)
		_sky.lensing = 1.0 if rides.ride.has_hole() else 0.0
		rides.toggle_pause()
		(_scene.get_node("%Readouts") as Readouts).update()
		(_scene.get_node("%RideBar") as RideBar).update()
		panel.refresh()
		await wait_process_frames(1)
		_assert_fits(_scene.get_node("%Frame") as Control, "%s, ride %d" % [p.locale, kind])
	var bottom: Control = _scene.get_node("%RideBar").get_parent()
	var both := bottom.get_combined_minimum_size().y + panel.get_combined_minimum_size().y
	assert_lt(both, WINDOW.y - 60.0, "the panel does not cover the bar")


func test_the_tabs_of_the_panel_fit(p: Variant = use_parameters(_locales)) -> void:
	TranslationServer.set_locale(p.locale)
	var panel: SkyPanel = _scene.get_node("%Panel")
	panel.toggle()
	await wait_process_frames(2)
	var bar := (panel.get_node("%Tabs") as TabContainer).get_tab_bar()
	assert_false(bar.get_offset_buttons_visible(), "%s: no arrows" % p.locale)


func test_the_help_fits(p: Variant = use_parameters(_locales)) -> void:
	TranslationServer.set_locale(p.locale)
	_help.open()
	await wait_process_frames(1)
	_assert_fits(_help, p.locale)
