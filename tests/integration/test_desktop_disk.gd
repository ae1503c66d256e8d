# SPDX-License-Identifier: MIT
extends "res://tests/integration/desktop_test.gd"
## The accretion disk: by keys, by the panel's page, its time, its legend and its copy on the map.

var _disk: AccretionDisk
var _switches: DiskSwitches
var _clock: DiskClock
var _panel: SkyPanel
var _page: DiskPage


func before_each() -> void:
	super()
	_disk = _sky.get_node("Disk")
	_switches = _scene.get_node("DiskSwitches")
	_clock = _scene.get_node("DiskClock")
	_panel = _scene.get_node("%Panel")
	_page = _panel.get_node("%DiskPage")


func _slider(slider_name: String) -> ValueSlider:
	return _page.get_node("%" + slider_name)


func _stepper(stepper_name: String) -> Stepper:
	return _page.get_node("%" + stepper_name)


func _box(box_name: String) -> CheckBox:
	return _page.get_node("%" + box_name)


func _assert_preset(preset: String) -> void:
	var values := DiskPresets.values(preset)
	for property: String in values:
		if property != "brightness_ev":
			assert_eq(_disk.get(property), values[property], "%s of %s" % [property, preset])
	assert_lte(_disk.brightness_ev, _switches.brightest, "%s beside stars" % preset)


func test_there_is_none_at_first_and_the_key_shows_and_hides_it() -> void:
	assert_false(_disk.visible)
	_assert_preset(DiskPresets.DEFAULT)
	_press(_key_event(KEY_T))
	assert_true(_disk.visible)
	_press(_key_event(KEY_T))
	assert_false(_disk.visible)


func test_the_other_key_goes_through_the_presets() -> void:
	_press(_key_event(KEY_V))
	assert_true(_disk.visible, "shown first")
	assert_eq(_switches.preset, DiskPresets.DEFAULT)
	var seen: Array[String] = []
	for i in DiskPresets.NAMES.size():
		_press(_key_event(KEY_V))
		seen.append(_switches.preset)
		_assert_preset(_switches.preset)
	assert_eq(seen, ["physicist", "film", "museum"] as Array[String])


func test_the_inclination_is_that_of_the_first_view() -> void:
	var outward := _controls.rig.get_position().normalized()
	var right := _controls.rig.get_orientation() * Vector3.RIGHT
	for degrees: float in [0.0, 30.0, 90.0]:
		_switches.inclination = degrees
		var normal := _disk.global_basis.y
		assert_almost_eq(rad_to_deg(normal.angle_to(outward)), degrees, 0.05)
		assert_almost_eq(normal.dot(right), 0.0, 1e-4, "the horizontal line stays")
	var up := _controls.rig.get_orientation() * Vector3.UP
	assert_almost_eq(_disk.global_basis.y, up, Vector3.ONE * 1e-3, "edge on")


func test_each_slider_sets_its_value_and_says_it() -> void:
	_panel.toggle()
	var changes: Dictionary[String, Array] = {
		"OuterRadius": ["outer_radius", 22.5, "22.5 rₛ"],
		"Temperature": ["peak_temperature", 7200.0, "7200 K"],
		"Brightness": ["brightness_ev", -30.5, "−30.5 EV"],
		"Opacity": ["opacity", 0.45, "0.45"],
	}
	for slider_name in changes:
		var change: Array = changes[slider_name]
		var property: StringName = change[0]
		var value: float = change[1]
		_slider(slider_name).value = value
		var taken: float = _disk.get(property)
		assert_almost_eq(taken, value, 1e-6, slider_name)
		_panel.refresh()
		assert_eq(_slider(slider_name).label.text, change[2])
	_slider("Inclination").value = 35.0
	assert_almost_eq(_switches.inclination, 35.0, 1e-6)
	_slider("TimeLapse").value = 0.0
	assert_eq(_clock.rate, 0.0)


func test_a_value_beyond_a_slider_is_left_as_it_is() -> void:
	_disk.outer_radius = 200.0
	_disk.opacity = 0.97
	_panel.toggle()
	assert_eq(_disk.outer_radius, 200.0)
	assert_eq(_slider("OuterRadius").label.text, "200.0 rₛ")
	assert_eq(_slider("Opacity").label.text, "0.97")


func test_choices_and_boxes_of_the_page() -> void:
	_panel.toggle()
	_box("Shown").button_pressed = true
	assert_true(_disk.visible)
	_box("Plunging").button_pressed = true
	assert_true(_disk.plunging_gas)
	_box("Retrograde").button_pressed = true
	assert_true(_disk.retrograde)
	var preset := _stepper("Preset")
	assert_eq(preset.titles.size(), DiskPresets.NAMES.size())
	preset.chosen.emit(2)
	_assert_preset("film")
	var look := _stepper("Look")
	assert_eq(look.titles.size(), AccretionDisk.LOOK_RINGS + 1)
	look.chosen.emit(AccretionDisk.LOOK_CHECKERBOARD)
	assert_eq(_disk.look, AccretionDisk.LOOK_CHECKERBOARD)
	_stepper("DiskOrders").chosen.emit(0)
	assert_eq(_disk.orders, 1)
	_panel.refresh()
	assert_eq(preset.at, 2)
	assert_string_contains(look.text, "Checkerboard")
	assert_string_contains(_stepper("DiskOrders").text, "1")


func test_time_passes_at_the_chosen_rate() -> void:
	_clock.rate = 7.0
	_clock.follow()
	assert_eq(_disk.time_scale, 7.0)
	_clock.rate = 0.0
	_clock.follow()
	assert_eq(_disk.time_scale, 0.0)


func test_on_a_ride_time_is_the_rides() -> void:
	var rides: RideDirector = _scene.get_node("Rides")
	rides.set_process(false)
	_clock.set_process(false)
	_disk.time = 100.0
	assert_true(rides.start(RideDirector.Kind.AS_RAIN))
	rides.seek(0.3)
	_clock.follow()
	assert_almost_eq(_disk.time, 100.0, 1e-6, "goes on from where it was")
	assert_eq(_disk.time_scale, 0.0)
	var begun := rides.ride.get_rain_time()
	rides.seek(0.6)
	_clock.follow()
	assert_almost_eq(_disk.time, 100.0 + rides.ride.get_rain_time() - begun, 1e-6)
	assert_gt(_disk.time, 101.0)
	_panel.toggle()
	assert_false(_slider("TimeLapse").editable)
	rides.seek(0.3)
	_clock.follow()
	assert_almost_eq(_disk.time, 100.0, 1e-6, "backwards")
	rides.leave()
	_clock.follow()
	assert_eq(_disk.time_scale, _clock.rate)
	_panel.refresh()
	assert_true(_slider("TimeLapse").editable)


func test_a_flight_without_the_hole_leaves_its_time_alone() -> void:
	var rides: RideDirector = _scene.get_node("Rides")
	rides.set_process(false)
	assert_true(rides.start(RideDirector.Kind.VELOCITY))
	_clock.follow()
	assert_eq(_disk.time_scale, _clock.rate)


func test_the_legend_is_there_while_the_disk_shows_the_shift() -> void:
	var legend: Control = _scene.get_node("%Legend")
	_disk.look = AccretionDisk.LOOK_REDSHIFT
	await wait_process_frames(2)
	assert_false(legend.visible, "no disk")
	_disk.show()
	await wait_process_frames(2)
	assert_true(legend.visible)
	_disk.look = AccretionDisk.LOOK_TEMPERATURE
	await wait_process_frames(2)
	assert_false(legend.visible)


func test_the_map_has_the_same_disk() -> void:
	var map: MapWindow = _scene.get_node("%Map")
	map.open()
	var view: MapView = map.get_node("%MapView")
	var copy: AccretionDisk = view.get_map_sky().find_children("*", "AccretionDisk", true, false)[0]
	view.follow()
	assert_false(copy.visible)
	_disk.show()
	_switches.preset = "film"
	_switches.inclination = 20.0
	_disk.retrograde = true
	_disk.time = 40.0
	view.follow()
	assert_true(copy.visible)
	for property: StringName in [
		&"look", &"outer_radius", &"peak_temperature", &"opacity", &"orders", &"retrograde", &"time"
	]:
		assert_eq(copy.get(property), _disk.get(property), property)
	assert_eq(copy.global_basis, _disk.global_basis)
	assert_eq(copy.time_scale, 0.0, "its time is the picture's")
	var exposed_more := view.get_map_sky().exposure - _sky.get_effective_exposure()
	assert_almost_eq(copy.brightness_ev, _disk.brightness_ev - exposed_more, 1e-6, "as bright")
