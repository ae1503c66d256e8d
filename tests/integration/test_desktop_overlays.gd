# SPDX-License-Identifier: MIT
extends "res://tests/integration/desktop_test.gd"
## Lines and names over the sky: switched by keys and by the panel, read when first wanted, and what
## happens when their files are damaged.

const BAKE_SECONDS: float = 20.0

var _overlays: SkyOverlays
var _labels: SkyLabels
var _panel: SkyPanel
var _folder: ScratchFolder


func before_all() -> void:
	super()
	_folder = ScratchFolder.new("desktop_overlays")


func after_all() -> void:
	super()
	_folder = null


func before_each() -> void:
	super()
	_overlays = _scene.get_node("Overlays")
	_labels = _scene.get_node("Display/Labels")
	_panel = _scene.get_node("%Panel")


func _until_read() -> void:
	var read := func() -> bool: return not _overlays.is_computing()
	assert_true(await wait_until(read, BAKE_SECONDS), "read in time")


func _has(overlay: BlackHoleSky.Overlay) -> bool:
	return _sky.overlays & overlay != 0


func test_nothing_is_over_the_sky_and_nothing_is_read_at_first() -> void:
	await wait_process_frames(2)
	assert_eq(_sky.overlays, 0)
	assert_null(_sky.figure_field)
	assert_false(_labels.stars_shown or _labels.constellations_shown)
	assert_eq(_labels.stars.names.size(), 0)


func test_the_key_for_names() -> void:
	_press(_key_event(KEY_N))
	assert_true(_overlays.is_computing(), "on a worker thread")
	assert_true(_overlays.are_constellations_wanted())
	assert_false(_has(BlackHoleSky.OVERLAY_CONSTELLATIONS), "not before there is a field")
	await _until_read()
	assert_not_null(_sky.figure_field)
	assert_true(_has(BlackHoleSky.OVERLAY_CONSTELLATIONS))
	assert_eq(_labels.figures.figures.size(), 88)
	assert_true(_labels.constellations_shown and _labels.stars_shown)
	assert_gt(_labels.stars.names.size(), 50)
	var field := _sky.figure_field
	_press(_key_event(KEY_N))
	assert_false(_has(BlackHoleSky.OVERLAY_CONSTELLATIONS))
	assert_false(_labels.constellations_shown or _labels.stars_shown)
	_press(_key_event(KEY_N))
	assert_false(_overlays.is_computing(), "made once")
	assert_true(_has(BlackHoleSky.OVERLAY_CONSTELLATIONS))
	assert_eq(_sky.figure_field, field)


func test_what_is_unwanted_again_before_it_is_read_stays_away() -> void:
	_overlays.want_constellations(true)
	_overlays.want_constellations(false)
	await _until_read()
	assert_false(_has(BlackHoleSky.OVERLAY_CONSTELLATIONS) or _labels.constellations_shown)


func test_the_key_for_lines_of_the_hole_remembers_the_choice() -> void:
	_sky.overlays = BlackHoleSky.OVERLAY_GALACTIC_GRID
	_press(_key_event(KEY_G))
	assert_true(_has(BlackHoleSky.OVERLAY_SHADOW_EDGE) and _has(BlackHoleSky.OVERLAY_MOTION))
	assert_true(_has(BlackHoleSky.OVERLAY_GALACTIC_GRID), "not the hole's: stays")
	_overlays.want(BlackHoleSky.OVERLAY_SHADOW_EDGE, false)
	_press(_key_event(KEY_G))
	assert_eq(_sky.overlays, BlackHoleSky.OVERLAY_GALACTIC_GRID)
	_press(_key_event(KEY_G))
	assert_false(_has(BlackHoleSky.OVERLAY_SHADOW_EDGE))
	assert_true(_has(BlackHoleSky.OVERLAY_MOTION))


func test_damaged_constellations_are_said_and_can_be_mended() -> void:
	_overlays.figures_file = _folder.write_text("broken.json", '{"constellations": [7]}')
	_overlays.want_constellations(true)
	await _until_read()
	assert_null(_sky.figure_field)
	assert_false(_overlays.are_constellations_wanted())
	assert_false(_has(BlackHoleSky.OVERLAY_CONSTELLATIONS) or _labels.constellations_shown)
	var notice := _notices.get_text(SkyOverlays.CONSTELLATIONS)
	assert_string_contains(notice, "broken.json")
	assert_string_contains(notice, "Copy the file from the addon again")
	_overlays.figures_file = ConstellationFigures.FILE
	_overlays.want_constellations(true)
	await _until_read()
	assert_true(_has(BlackHoleSky.OVERLAY_CONSTELLATIONS), "read again")


func test_damaged_star_names_are_said_and_can_be_mended() -> void:
	_overlays.names_file = _folder.write_text("broken.csv", "hip,name\n1,Sirius\n")
	_overlays.want_star_names(true)
	assert_false(_overlays.are_star_names_shown())
	var notice := _notices.get_text(SkyOverlays.STAR_NAMES)
	assert_string_contains(notice, "broken.csv")
	assert_string_contains(notice, "Copy the file from the addon again")
	_overlays.want_star_names(false)
	_overlays.names_file = StarNames.FILE
	_overlays.want_star_names(true)
	assert_true(_overlays.are_star_names_shown())


func test_leaving_while_reading_is_harmless() -> void:
	_overlays.want_constellations(true)
	_scene.free()
	await wait_process_frames(2)
	pass_test("no crash")


func test_each_switch_of_the_panel_is_its_line() -> void:
	_panel.toggle()
	var lines: Dictionary[String, BlackHoleSky.Overlay] = {
		"EquatorialGrid": BlackHoleSky.OVERLAY_EQUATORIAL_GRID,
		"GalacticGrid": BlackHoleSky.OVERLAY_GALACTIC_GRID,
		"ShadowEdge": BlackHoleSky.OVERLAY_SHADOW_EDGE,
		"EinsteinRings": BlackHoleSky.OVERLAY_EINSTEIN_RINGS,
		"Motion": BlackHoleSky.OVERLAY_MOTION,
		"ShadowDiameter": BlackHoleSky.OVERLAY_SHADOW_DIAMETER,
		"StraightLight": BlackHoleSky.OVERLAY_STRAIGHT_LIGHT,
	}
	for box_name in lines:
		var box: CheckBox = _panel.get_node("%" + box_name)
		box.button_pressed = true
		assert_eq(_sky.overlays, lines[box_name], box_name)
		box.button_pressed = false
		assert_eq(_sky.overlays, 0, box_name)
	(_panel.get_node("%StarNames") as CheckBox).button_pressed = true
	assert_true(_labels.stars_shown)
	(_panel.get_node("%Constellations") as CheckBox).button_pressed = true
	await _until_read()
	assert_true(_has(BlackHoleSky.OVERLAY_CONSTELLATIONS) and _labels.constellations_shown)


func test_choices_by_left_and_right() -> void:
	_panel.toggle()
	(_panel.get_node("%Tabs") as TabContainer).current_tab = 3
	await wait_process_frames(2)
	var projection: Stepper = _panel.get_node("%Projection")
	assert_eq(projection.titles.size(), BlackHoleSky.PROJECTION_FISHEYE_360 + 1)
	projection.grab_focus()
	for event: InputEvent in [_key_event(KEY_RIGHT), _button_event(JOY_BUTTON_DPAD_RIGHT)]:
		_press(event)
	assert_eq(_sky.projection, BlackHoleSky.PROJECTION_MERCATOR)
	assert_string_contains(projection.text, "Mercator")
	for i in 3:
		_press(_key_event(KEY_LEFT))
	assert_eq(_sky.projection, BlackHoleSky.PROJECTION_FISHEYE_360, "round")
	var spread: Stepper = _panel.get_node("%Spread")
	assert_eq(spread.at, BlackHoleSky.PSF_GAUSSIAN)
	spread.grab_focus()
	_press(_key_event(KEY_ENTER))
	assert_eq(_sky.psf_model, BlackHoleSky.PSF_AIRY)
	assert_string_contains(spread.text, "Diffraction")
	(_panel.get_node("%Orders") as Stepper).grab_focus()
	_sky.image_orders = 3
	_panel.refresh()
	_press(_button_event(JOY_BUTTON_A))
	assert_eq(_sky.image_orders, 4)
	_press(_button_event(JOY_BUTTON_DPAD_RIGHT))
	assert_eq(_sky.image_orders, 1)
