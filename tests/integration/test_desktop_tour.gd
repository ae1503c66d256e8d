# SPDX-License-Identifier: MIT
extends "res://tests/integration/desktop_test.gd"
## The guided tour in the desktop scene: every station is where it says, by itself and by every
## device, and afterwards all is as before.

const STEP: float = 0.1

var _guide: TourGuide
var _stage: DesktopTourStage
var _captions: TourCaptions
var _rides: RideDirector


func before_each() -> void:
	super()
	_guide = _scene.get_node("%TourGuide")
	_stage = _guide.stage
	_captions = _stage.captions
	_rides = _scene.get_node("Rides")
	_rides.set_process(false)


# Keys are for the tour only while it processes: time passes here, and none by itself.
func _elapse(seconds: float) -> void:
	for i in ceili(seconds / STEP):
		if _guide.is_on():
			_guide.advance(STEP)
		_rides.advance(STEP)
		_controls.advance(STEP)


func _begin(station: int = 0) -> void:
	assert_true(_guide.start(TourFile.read(_guide.tour_file).tour, station))


func _station_of(id: StringName) -> int:
	for i in _guide.tour.stations.size():
		if _guide.tour.stations[i].id == id:
			return i
	return -1


func _go_to(id: StringName) -> void:
	_begin()
	_begin(_station_of(id))
	_guide.automatic = false
	_elapse(7.0)


func _state() -> Dictionary[String, Variant]:
	var state: Dictionary[String, Variant] = {}
	for property: String in ["background", "image_orders", "overlays", "exposure", "projection"]:
		state[property] = _sky.get(property)
	for property: String in ["auto_exposure", "redshift_map", "effect_doppler"]:
		state[property] = _sky.get(property)
	var disk: DiskSwitches = _scene.get_node("DiskSwitches")
	state["disk"] = [disk.preset, disk.inclination, disk.disk.visible, disk.disk.look]
	state["eye"] = [_controls.mode, _controls.listening, _stage.camera.fov]
	state["camera"] = [_stage.camera.projection, _stage.router.restricted]
	state["observer kind"] = _stage.choice.get_kind()
	state["panel"] = (_scene.get_node("%Panel") as Control).visible
	return state


func test_the_whole_tour_runs_by_itself_and_leaves_everything_as_it_was() -> void:
	_sky.overlays = BlackHoleSky.OVERLAY_GALACTIC_GRID
	_sky.effect_doppler = false
	var disk: DiskSwitches = _scene.get_node("DiskSwitches")
	disk.toggle()
	disk.disk.look = AccretionDisk.LOOK_CHECKERBOARD
	_controls.rig.turn(0.3, 0.1, 0.0)
	_controls.mode = ViewControls.Mode.FLIGHT
	var place := _controls.rig.get_position()
	var orientation := _controls.rig.get_orientation()
	var before := _state()
	watch_signals(_guide)
	_begin()
	var total := _guide.tour.stations.size()
	var seconds := 0.0
	while _guide.is_on() and seconds < 900.0:
		_elapse(1.0)
		seconds += 1.0
		assert_true(_controls.rig.get_position().is_finite())
	gut.p("the tour takes %d s" % seconds)
	assert_signal_emitted_with_parameters(_guide, "finished", [true])
	assert_signal_emit_count(_guide, "station_begun", total)
	assert_between(seconds, 240.0, 600.0, "minutes of a visitor's time")
	# What the scene does then is not the tour's matter.
	(_scene.get_node("%MainMenu") as MenuScreen).close()
	assert_eq(_state(), before)
	assert_almost_eq(_controls.rig.get_position(), place, Vector3.ONE * 1e-4)
	assert_lt(_controls.rig.get_orientation().angle_to(orientation), 1e-3)
	assert_eq(_notices.get_text(RideDirector.TOPIC), "", "no ride complained")
	assert_eq(_notices.get_text(ObserverChoice.TOPIC), "", "nor an observer")


func test_stations_stand_where_they_say() -> void:
	_begin()
	_guide.automatic = false
	for i in _guide.tour.stations.size():
		if i > 0:
			_guide.next_station()
		var station := _guide.get_station()
		_elapse(0.2)
		for wait in 100:
			if _stage.is_arrived():
				break
			_elapse(STEP)
		if station.motion == TourStation.Motion.HOVER:
			assert_almost_eq(
				_controls.rig.get_distance() / station.radius, 1.0, 1e-4, station.title
			)
			assert_null(_rides.ride, station.title)
		else:
			assert_true(_rides.is_on(), station.title)
			assert_between(_controls.rig.get_distance() / station.radius, 0.9, 1.001, station.title)
		var observer := _sky.observer
		assert_eq(observer.get_refusal(_controls.rig.get_position()), "", station.title)


func test_a_caption_takes_the_hole_away_and_the_next_brings_it_back() -> void:
	_go_to(&"weak_lensing")
	assert_eq(_sky.lensing, 0.0)
	_guide.next()
	_elapse(1.2)
	assert_between(_sky.lensing, 0.1, 0.9)
	_elapse(2.0)
	assert_eq(_sky.lensing, 1.0)


func test_captions_lead_nearer_and_back() -> void:
	_go_to(&"shadow_sizes")
	assert_almost_eq(_controls.rig.get_distance(), 10.0, 1e-3)
	for i in 3:
		_guide.next()
	_elapse(7.0)
	assert_almost_eq(_controls.rig.get_distance(), 2.5, 1e-3)
	_guide.previous()
	_elapse(7.0)
	assert_almost_eq(_controls.rig.get_distance(), 3.0, 1e-3)


func test_a_fall_is_where_a_caption_belongs_when_gone_on_by_hand() -> void:
	_go_to(&"fall")
	_guide.next()
	_guide.next()
	assert_almost_eq(_controls.rig.get_distance(), 1.0, 1e-3)
	_elapse(60.0)
	assert_almost_eq(_controls.rig.get_distance(), _guide.get_station().waits_at, 0.02)
	_guide.previous()
	assert_almost_eq(_controls.rig.get_distance(), 5.0, 1e-3)
	_guide.leave()
	assert_almost_eq(_controls.rig.get_distance(), StartView.DISTANCE, 1e-3)
	assert_eq(_stage.choice.get_kind(), ObserverKind.Kind.STATIC)


func test_a_pause_holds_the_fall() -> void:
	_go_to(&"fall")
	_guide.set_paused(true)
	var distance := _controls.rig.get_distance()
	_elapse(3.0)
	assert_eq(_controls.rig.get_distance(), distance)
	_guide.set_paused(false)
	_elapse(1.0)
	assert_lt(_controls.rig.get_distance(), distance)


func test_looking_back_turns_away_from_the_hole() -> void:
	_go_to(&"looking_back")
	var ahead := _controls.rig.get_orientation() * Vector3.FORWARD
	assert_lt(ahead.dot(_controls.hole_direction), -0.99)
	_guide.next()
	_guide.next()
	_elapse(6.0)
	ahead = _controls.rig.get_orientation() * Vector3.FORWARD
	assert_almost_eq(ahead.dot(_controls.hole_direction), 0.0, 0.05)


func test_every_device_goes_through_the_tour() -> void:
	var next := [_key_event(KEY_RIGHT), _key_event(KEY_ENTER), _button_event(JOY_BUTTON_A)]
	next.append_array([_button_event(JOY_BUTTON_DPAD_RIGHT)])
	next.append(_button_event(JOY_BUTTON_RIGHT_SHOULDER))
	var previous := [_key_event(KEY_LEFT), _button_event(JOY_BUTTON_DPAD_LEFT)]
	previous.append(_button_event(JOY_BUTTON_LEFT_SHOULDER))
	var pause := [_key_event(KEY_SPACE), _button_event(JOY_BUTTON_X)]
	var leave := [_key_event(KEY_ESCAPE), _button_event(JOY_BUTTON_B)]
	for event: InputEvent in next:
		_begin()
		get_tree().root.push_input(event)
		assert_eq(_guide.caption_index, 1, event.as_text())
	for event: InputEvent in previous:
		_guide.next_station()
		_guide.next()
		get_tree().root.push_input(event)
		assert_eq(_guide.caption_index, 0, event.as_text())
	for event: InputEvent in pause:
		get_tree().root.push_input(event)
		assert_true(_guide.is_paused(), event.as_text())
		_guide.set_paused(false)
	for event: InputEvent in [_key_event(KEY_PAGEDOWN), _button_event(JOY_BUTTON_DPAD_DOWN)]:
		_begin()
		get_tree().root.push_input(event)
		assert_eq(_guide.station_index, 1, event.as_text())
	for event: InputEvent in leave:
		_begin()
		get_tree().root.push_input(event)
		assert_false(_guide.is_on(), event.as_text())


func test_the_mouse_presses_the_buttons() -> void:
	var size_before := get_window().size
	get_window().size = Vector2i(1280, 720)
	_begin()
	await wait_process_frames(2)
	var button: Button = _captions.get_node("%Next")
	for pressed: bool in [true, false]:
		var click := InputEventMouseButton.new()
		click.button_index = MOUSE_BUTTON_LEFT
		click.pressed = pressed
		click.position = button.get_global_rect().get_center()
		click.global_position = click.position
		_captions.get_viewport().push_input(click, true)
	get_window().size = size_before
	assert_eq(_guide.caption_index, 1)


func test_nothing_else_answers_meanwhile() -> void:
	_begin()
	_elapse(6.0)
	var orders := _sky.image_orders
	get_tree().root.push_input(_key_event(KEY_I))
	assert_eq(_sky.image_orders, orders)
	var place := _controls.rig.get_position()
	_hold(_key_event(KEY_W))
	_let_pass(1.0)
	assert_eq(_controls.rig.get_position(), place)


func test_captions_are_shown_in_the_language_and_size_that_is_set() -> void:
	_begin()
	var text: Label = _captions.get_node("%Text")
	var number: Label = _captions.get_node("%Number")
	assert_eq(text.text, _guide.get_caption().text)
	assert_eq(number.text, "1 / %d" % _guide.tour.stations.size())
	TranslationServer.set_locale("de")
	await wait_process_frames(2)
	assert_string_contains(text.text, "Milchstraße")
	TranslationServer.set_locale("en")
	var before := text.get_theme_font_size(&"font_size")
	_captions.text_scale = 1.5
	assert_eq(text.get_theme_font_size(&"font_size"), roundi(1.5 * before))
	_captions.captions_shown = false
	assert_false(text.visible)
	_captions.captions_shown = true
	assert_true(text.visible)
	_guide.leave()
	assert_false((_captions.get_node("%Band") as Control).visible)


func test_under_a_menu_the_tour_rests() -> void:
	_begin()
	_guide.set_process(false)
	get_tree().root.push_input(_key_event(KEY_RIGHT))
	assert_eq(_guide.caption_index, 0)


func test_every_caption_fits_its_band_in_every_language_and_size() -> void:
	var size_before := get_window().size
	var text: Label = _captions.get_node("%Text")
	_begin()
	for locale in LanguagePage.locales():
		TranslationServer.set_locale(locale)
		for size: Vector2i in [Vector2i(1280, 720), Vector2i(1920, 1080)]:
			get_window().size = size
			for text_scale: float in [1.0, 1.5]:
				_captions.text_scale = text_scale
				await wait_process_frames(2)
				for station in _guide.tour.stations:
					for caption in station.captions:
						text.text = tr(caption.text)
						assert_lte(text.get_line_count(), 2, "%s, %s" % [locale, text.text])
				assert_lt(_captions.get_covered_share(), DesktopTourStage.MOST_COVERED)
	get_window().size = size_before
	TranslationServer.set_locale("en")
