# SPDX-License-Identifier: MIT
extends GutTest
## The settings are gone through and changed by keyboard alone and by gamepad alone.

const SCENE: PackedScene = preload("res://scenes/settings/settings_screen.tscn")
const GERMAN: String = "res://scenes/settings/locale/de.po"

var _settings: UserSettings
var _screen: SettingsScreen
var _locale: String


func before_each() -> void:
	_locale = TranslationServer.get_locale()
	TranslationServer.set_locale("en")
	_settings = UserSettings.new()
	_settings.file = ""
	add_child_autofree(_settings)
	_screen = SCENE.instantiate() as SettingsScreen
	_screen.settings = _settings
	add_child_autofree(_screen)
	_screen.open()
	# The focus comes a little later.
	await wait_process_frames(1)


func after_each() -> void:
	TranslationServer.set_locale(_locale)


func _focus() -> Control:
	return get_viewport().gui_get_focus_owner()


func _tab() -> int:
	return (_screen.get_node("%Tabs") as TabContainer).current_tab


func _cell(action: StringName, device: InputBindings.Device) -> BindingCell:
	for cell in _screen._controls_page()._cells:
		if cell.action == action and cell.device == device:
			return cell
	return null


func _ask(cell: BindingCell) -> void:
	_screen.turn_to(SettingList.PAGES.find(SettingList.CONTROLS))
	await wait_process_frames(1)
	cell.grab_focus()
	DeviceInput.press(DeviceInput.key(KEY_ENTER))
	await wait_process_frames(1)


# Goes down from row to row and changes each of the page by going right or left.
func _assert_all_is_changed(page: StringName, down: InputEvent, ways: Array[InputEvent]) -> void:
	for setting in SettingList.of_page(page):
		if setting.kind == Setting.Kind.BINDINGS:
			continue
		for way in ways:
			if _settings.is_initial(setting.key):
				DeviceInput.press(way)
		assert_false(_settings.is_initial(setting.key), "%s is changed" % setting.key)
		DeviceInput.press(down)
		await wait_process_frames(1)


func test_every_setting_is_changed_by_either_device() -> void:
	var devices: Array[Array] = [
		[
			DeviceInput.key(KEY_DOWN),
			DeviceInput.key(KEY_RIGHT),
			DeviceInput.key(KEY_LEFT),
			DeviceInput.key(KEY_PAGEDOWN)
		],
		[
			DeviceInput.button(JOY_BUTTON_DPAD_DOWN),
			DeviceInput.button(JOY_BUTTON_DPAD_RIGHT),
			DeviceInput.button(JOY_BUTTON_DPAD_LEFT),
			DeviceInput.button(JOY_BUTTON_RIGHT_SHOULDER),
		],
	]
	for device in devices:
		for at in SettingList.PAGES.size():
			assert_eq(_tab(), at)
			await wait_process_frames(1)
			await _assert_all_is_changed(SettingList.PAGES[at], device[0], [device[1], device[2]])
			DeviceInput.press(device[3])
		for page in SettingList.PAGES:
			_settings.reset_page(page)
	for key in SettingList.keys():
		assert_true(_settings.is_initial(key), key)


func test_pages_turn_both_ways_round() -> void:
	for event: InputEvent in [
		DeviceInput.key(KEY_PAGEUP), DeviceInput.button(JOY_BUTTON_LEFT_SHOULDER)
	]:
		var before := _tab()
		DeviceInput.press(event)
		assert_eq(_tab(), posmod(before - 1, 5))
	var both := DeviceInput.key(KEY_TAB)
	both.ctrl_pressed = true
	DeviceInput.press(both)
	assert_eq(_tab(), 4)


func test_it_closes() -> void:
	for event: InputEvent in [DeviceInput.key(KEY_ESCAPE), DeviceInput.button(JOY_BUTTON_B)]:
		_screen.open()
		assert_true(_screen.visible)
		DeviceInput.press(event)
		assert_false(_screen.visible)


func test_a_page_is_reset() -> void:
	_settings.set_value(&"quality", "low")
	_settings.set_value(&"volume", 10.0)
	(_screen.get_node("%Reset") as Button).pressed.emit()
	assert_true(_settings.is_initial(&"quality"))
	assert_false(_settings.is_initial(&"volume"), "another page")


func test_reset_button_is_reached_from_the_last_row() -> void:
	for i in 12:
		DeviceInput.press(DeviceInput.key(KEY_DOWN))
		await wait_process_frames(1)
	assert_eq(_focus().get_parent().name, &"Foot")


func test_a_key_is_bound() -> void:
	var cell := _cell(&"toggle_map", InputBindings.Device.KEYBOARD)
	await _ask(cell)
	var capture: BindingCapture = _screen.get_node("%Capture")
	assert_true(capture.visible)
	DeviceInput.press(DeviceInput.button(JOY_BUTTON_Y))
	assert_true(capture.visible, "a button is no key")
	DeviceInput.press(DeviceInput.key(KEY_U))
	assert_false(capture.visible)
	assert_eq(_settings.get_value(&"bindings"), {"toggle_map": ["key:U"]})
	assert_eq(cell.words(), "U")
	assert_eq(_focus(), cell)


func test_a_button_is_bound_even_the_one_that_goes_back() -> void:
	var cell := _cell(&"toggle_map", InputBindings.Device.GAMEPAD)
	await _ask(cell)
	DeviceInput.press(DeviceInput.button(JOY_BUTTON_B))
	assert_true(_screen.visible)
	assert_eq(_settings.get_value(&"bindings"), {"toggle_map": ["key:M", "pad:b"]})
	var words: Label = _screen.get_node("%Words")
	assert_string_contains(words.text, "With and without the hole")


func test_escape_and_time_leave_it_as_it_is() -> void:
	var capture: BindingCapture = _screen.get_node("%Capture")
	var cell := _cell(&"toggle_map", InputBindings.Device.KEYBOARD)
	await _ask(cell)
	DeviceInput.press(DeviceInput.key(KEY_ESCAPE))
	assert_false(capture.visible)
	assert_true(_screen.visible, "Escape ended the question alone")
	await _ask(cell)
	capture._process(4.9)
	assert_true(capture.visible)
	capture._process(0.2)
	assert_false(capture.visible)
	assert_true(_settings.is_initial(&"bindings"))
	assert_eq(_focus(), cell)


func test_what_opens_the_menu_is_not_given_away() -> void:
	await _ask(_cell(&"toggle_map", InputBindings.Device.GAMEPAD))
	DeviceInput.press(DeviceInput.button(JOY_BUTTON_START))
	assert_true(_settings.is_initial(&"bindings"))
	assert_string_contains((_screen.get_node("%Words") as Label).text, "menu")


func test_clear_and_as_at_first() -> void:
	var cell := _cell(&"toggle_map", InputBindings.Device.KEYBOARD)
	_screen.turn_to(SettingList.PAGES.find(SettingList.CONTROLS))
	await wait_process_frames(1)
	for pair: Array in [
		[DeviceInput.key(KEY_DELETE), DeviceInput.key(KEY_BACKSPACE)],
		[DeviceInput.button(JOY_BUTTON_X), DeviceInput.button(JOY_BUTTON_Y)],
	]:
		cell.grab_focus()
		DeviceInput.press(pair[0])
		assert_eq(_settings.get_value(&"bindings"), {"toggle_map": []})
		DeviceInput.press(pair[1])
		assert_true(_settings.is_initial(&"bindings"))


func test_every_binding_has_a_picture_and_words() -> void:
	for cell in _screen._controls_page()._cells:
		var events := _screen._controls_page()._bindings.events_of(cell.action, cell.device)
		if not events.is_empty():
			assert_ne(cell.words(), "", cell.action)
	for words: String in ["mouse:middle", "mouse:back", "pad:share", "key:Shift", "sign:Plus"]:
		var glyph := InputGlyph.of_event(BindingText.to_event(words))
		add_child_autofree(glyph)
		assert_gt(glyph.custom_minimum_size.x, 10.0, words)
		assert_ne(glyph.tooltip_text, "", words)


func test_everything_has_german_words() -> void:
	var german: Array[Translation] = []
	for file in Languages.FILES:
		if ResourceLoader.exists(file):
			german.append(load(file) as Translation)
	var texts: Array[String] = ["Keyboard", "Mouse", "Gamepad"]
	texts.append_array(SettingsScreen.TITLES)
	for key in SettingList.keys():
		var setting := SettingList.find(key)
		texts.append(setting.title)
		texts.append(setting.note)
		for title in setting.titles:
			if not title.is_valid_int() and title not in ["English", "Deutsch"]:
				texts.append(title)
	for row in ActionList.ROWS:
		texts.append(String(row[0]) if row.size() == 1 else String(row[1]))
	for text in texts:
		var found := text.is_empty()
		for file in german:
			found = found or not String(file.get_message(text)).is_empty()
		assert_true(found, text)
