# SPDX-License-Identifier: MIT
extends GutTest
## The exhibit as a scene: a visit by gamepad alone, by keyboard alone, ways out that lead nowhere,
## the operator's way, and that the next visitor finds nothing of the last one.

const SCENE: PackedScene = preload("res://scenes/kiosk/kiosk.tscn")
const SETTINGS: Dictionary = {
	"mode": "screen",
	"health_notice": "always",
	"fullscreen": false,
	"pin": "4711",
	"language": "de",
}

var _kiosk: Kiosk
var _locale: String
var _folder: ScratchFolder
var _events: Dictionary[StringName, Array] = {}


func before_all() -> void:
	_locale = TranslationServer.get_locale()
	for action in InputMap.get_actions():
		_events[action] = InputMap.action_get_events(action)


func before_each() -> void:
	_folder = ScratchFolder.new("kiosk_scene")
	var settings := SETTINGS.duplicate()
	settings["log_folder"] = _folder.path
	_kiosk = SCENE.instantiate()
	_kiosk.config = KioskConfig.from_data(settings, "test")
	add_child(_kiosk)
	await _until_ready()


func after_each() -> void:
	_kiosk.free()
	_folder = null
	TranslationServer.set_locale(_locale)
	AudioServer.set_bus_volume_linear(0, 1.0)
	for action in _events:
		InputMap.action_erase_events(action)
		for event: InputEvent in _events[action]:
			InputMap.action_add_event(action, event)


func _until_ready() -> void:
	await wait_until(func() -> bool: return _kiosk.director.is_ready, 10.0)
	await wait_process_frames(2)


func _button(button: JoyButton) -> void:
	await _send(DeviceInput.button(button))


func _key(key: Key, ctrl: bool = false, shift: bool = false) -> void:
	var event := DeviceInput.key(key)
	event.unicode = key if key >= KEY_0 and key <= KEY_9 else 0
	event.ctrl_pressed = ctrl
	event.shift_pressed = shift
	await _send(event)


func _send(event: InputEvent) -> void:
	DeviceInput.press(event)
	await wait_process_frames(2)


func _is_at(state: VisitDirector.State) -> bool:
	assert_eq(VisitDirector.NAMES[_kiosk.director.state], VisitDirector.NAMES[state])
	return _kiosk.director.state == state


func _content() -> ExhibitContent:
	return _kiosk.get_node("Content")


func _panel() -> OperatorPanel:
	return _kiosk.get_node("Desk/Panel")


func test_a_visit_by_gamepad_alone() -> void:
	_is_at(VisitDirector.State.ATTRACT)
	assert_eq(TranslationServer.get_locale(), "de")
	await _button(JOY_BUTTON_X)
	_is_at(VisitDirector.State.LANGUAGE)
	await _button(JOY_BUTTON_DPAD_DOWN)
	await _button(JOY_BUTTON_A)
	_is_at(VisitDirector.State.HEALTH)
	assert_eq(TranslationServer.get_locale(), "en")
	await _button(JOY_BUTTON_B)
	_is_at(VisitDirector.State.LANGUAGE)
	await _button(JOY_BUTTON_A)
	await _button(JOY_BUTTON_A)
	_is_at(VisitDirector.State.CHOICE)
	await _button(JOY_BUTTON_DPAD_DOWN)
	await _button(JOY_BUTTON_A)
	_is_at(VisitDirector.State.VISIT)
	assert_eq(_kiosk.director.content, VisitDirector.FLIGHT)
	assert_true((_content().scene.get_node("Display") as CanvasLayer).visible)
	_kiosk.director.end(VisitDirector.TIME)
	_kiosk.director.advance(100.0)
	await _until_ready()
	_is_at(VisitDirector.State.ATTRACT)
	assert_eq(TranslationServer.get_locale(), "de", "as before")
	var line := FileAccess.get_file_as_string(_folder.file("visits.csv")).split("\n")[1]
	assert_string_contains(line, ",en,screen,flight,visit,")
	assert_true(line.ends_with(",time"), line)


func test_by_keyboard_alone_and_no_way_out() -> void:
	await _key(KEY_SPACE)
	for i in 3:
		await _key(KEY_ENTER)
	if not _is_at(VisitDirector.State.VISIT):
		return
	assert_eq(_kiosk.director.content, VisitDirector.TOUR)
	for key: Key in [KEY_ESCAPE, KEY_ESCAPE, KEY_F11, KEY_F4, KEY_Q, KEY_F8]:
		await _key(key)
	_kiosk.get_tree().root.propagate_notification(NOTIFICATION_WM_CLOSE_REQUEST)
	await wait_process_frames(3)
	assert_true(KioskMode.is_on())
	assert_false(_kiosk.get_tree().auto_accept_quit)
	for menu: MainMenu in _content().scene.find_children("*", "MainMenu", true, false):
		menu.open()
		for item: StringName in [MainMenu.QUIT, MainMenu.PHOTO, MainMenu.SETTINGS]:
			assert_false(menu.get_button(item).visible, item)
	for action: StringName in [&"quit", &"toggle_fullscreen"]:
		if InputMap.has_action(action):
			assert_eq(InputMap.action_get_events(action).size(), 0, action)


func test_the_next_visitor_finds_nothing_of_the_last() -> void:
	var sky := _content().get_sky()
	var orders := sky.image_orders
	_kiosk.director.wake(&"button")
	_kiosk.director.end(VisitDirector.DECLINED)
	await _until_ready()
	sky = _content().get_sky()
	sky.image_orders = 4
	sky.lensing = 0.0
	TranslationServer.set_locale("en")
	for settings: UserSettings in _content().scene.find_children("*", "UserSettings", true, false):
		assert_eq(settings.file, "", "nothing is kept")
	var nodes := get_tree().get_node_count()
	_kiosk.director.wake(&"button")
	_kiosk.director.end(VisitDirector.IDLE)
	await _until_ready()
	assert_ne(_content().get_sky(), sky)
	assert_eq(_content().get_sky().image_orders, orders)
	assert_eq(_content().get_sky().lensing, 1.0)
	assert_eq(TranslationServer.get_locale(), "de")
	assert_eq(get_tree().get_node_count(), nodes, "nothing is left over")


func test_the_operator_by_keyboard() -> void:
	await _key(KEY_F12, true, true)
	var pad: PinPad = _kiosk.get_node("Desk/PinPad")
	assert_true(pad.visible)
	for digit in "4712":
		await _key(OS.find_keycode_from_string(digit))
	await _key(KEY_KP_ENTER)
	assert_false(_panel().visible, "a wrong one")
	assert_gt(pad.pin.get_wait(Time.get_ticks_msec() * 1e-3), 1.0)
	pad.pin = KioskConfig.from_data(SETTINGS).get_pin()
	for digit in "4711":
		await _key(OS.find_keycode_from_string(digit))
	await _key(KEY_KP_ENTER)
	assert_true(_panel().visible)
	await _key(KEY_ENTER)
	_is_at(VisitDirector.State.ATTRACT)
	assert_true(_panel().visible, "its keys begin no visit")
	await _key(KEY_ESCAPE)
	assert_false(_panel().visible)
	await _key(KEY_ENTER)
	_is_at(VisitDirector.State.LANGUAGE)


func test_what_the_operator_does() -> void:
	_kiosk.director.wake(&"button")
	var desk: OperatorDesk = _kiosk.get_node("Desk")
	desk._open_panel()
	await wait_process_frames(2)
	for fact: Label in _panel().find_child("Facts").get_children():
		assert_ne(fact.text, "")
	_panel().volume_asked.emit(0.3)
	assert_almost_eq(AudioServer.get_bus_volume_linear(0), 0.3, 1e-4)
	_panel().language_asked.emit("en")
	assert_eq(TranslationServer.get_locale(), "en")
	_panel().recentre_asked.emit()
	_panel().reset_asked.emit()
	await _until_ready()
	_is_at(VisitDirector.State.ATTRACT)
	var lines := FileAccess.get_file_as_string(_folder.file("visits.csv"))
	assert_true(lines.strip_edges().ends_with("1,operator"), lines)
