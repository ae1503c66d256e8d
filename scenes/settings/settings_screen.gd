# SPDX-License-Identifier: MIT
class_name SettingsScreen
extends MenuScreen
## The settings, page by page, for keyboard, mouse and gamepad alike.

## Names of the pages, in the order of [constant SettingList.PAGES].
const TITLES: PackedStringArray = ["Picture", "Sound", "Controls", "Language", "Accessibility"]

@export var settings: UserSettings

var _pages: Array[SettingsPage] = []
var _asking: BindingCell

@onready var _tabs: TabContainer = %Tabs
@onready var _words: Label = %Words
@onready var _hints: KeyHints = %Hints
@onready var _reset: Button = %Reset
@onready var _back: Button = %Back
@onready var _capture: BindingCapture = %Capture


func _ready() -> void:
	_tabs.tab_changed.connect(_on_tab_changed)
	_reset.pressed.connect(_on_reset)
	_back.pressed.connect(close)
	_capture.captured.connect(_on_captured)
	_capture.given_up.connect(_on_given_up)


func _notification(what: int) -> void:
	if what == NOTIFICATION_TRANSLATION_CHANGED and is_node_ready() and not _pages.is_empty():
		_name_tabs()
		_show_hints()


func _input(event: InputEvent) -> void:
	if not visible or _capture.visible or not event.is_pressed() or event.is_echo():
		return
	var way := _way_through_pages(event)
	if way != 0:
		get_viewport().set_input_as_handled()
		turn_to(posmod(_tabs.current_tab + way, _pages.size()))
		return
	var cell := get_viewport().gui_get_focus_owner() as BindingCell
	if cell == null:
		return
	if _is_one_of(event, KEY_DELETE, JOY_BUTTON_X):
		get_viewport().set_input_as_handled()
		_controls_page().clear(cell)
	elif _is_one_of(event, KEY_BACKSPACE, JOY_BUTTON_Y):
		get_viewport().set_input_as_handled()
		_controls_page().reset_action(cell)


## Shows one of the pages.
func turn_to(page: int) -> void:
	_tabs.current_tab = page
	# The container shows the page a little later.
	_focus_first.call_deferred()


func get_first_focus() -> Control:
	return _pages[_tabs.current_tab].get_first_focus()


func _focus_first() -> void:
	if visible:
		get_first_focus().grab_focus()


# The pages are made when they are first wanted: the program starts sooner.
func _on_open() -> void:
	if _pages.is_empty():
		_make_pages()
	_tell("")
	_show_hints()
	_focus_first.call_deferred()


func _on_close() -> void:
	settings.save()


func _make_pages() -> void:
	for page in SettingList.PAGES:
		match page:
			SettingList.PICTURE:
				_pages.append(PictureSettings.new(settings))
			SettingList.CONTROLS:
				var controls := BindingsPage.new(settings)
				controls.asked.connect(_on_binding_asked)
				controls.told.connect(_tell)
				_pages.append(controls)
			_:
				_pages.append(SettingsPage.new(page, settings))
	for page in _pages:
		_tabs.add_child(page)
	_name_tabs()


func _controls_page() -> BindingsPage:
	return _pages[SettingList.PAGES.find(SettingList.CONTROLS)]


func _name_tabs() -> void:
	for at in _pages.size():
		_tabs.set_tab_title(at, tr(TITLES[at]))


func _on_tab_changed(_tab: int) -> void:
	_tell("")
	_show_hints()


func _show_hints() -> void:
	_hints.clear()
	_hints.add(["key:PageUp", "key:PageDown", "pad:left_shoulder", "pad:right_shoulder"], "Page")
	if _pages[_tabs.current_tab] is BindingsPage:
		_hints.add(["key:Enter", "pad:a"], "Change")
		_hints.add(["key:Delete", "pad:x"], "Clear")
		_hints.add(["key:Backspace", "pad:y"], "As at first")
	else:
		_hints.add(["key:Left", "key:Right"], "Change")
	_hints.add(["key:Escape", "pad:b"], "Back")


func _tell(text: String) -> void:
	_words.text = text


func _on_reset() -> void:
	_pages[_tabs.current_tab].reset()
	_tell(tr("This page is as at first."))


func _on_binding_asked(cell: BindingCell) -> void:
	_asking = cell
	_tell("")
	# The press that asks must not be the answer.
	_capture.ask.call_deferred(cell.action, cell.device)


func _on_captured(event: InputEvent) -> void:
	_controls_page().bind(_asking, event)
	_asking.grab_focus()


func _on_given_up() -> void:
	_asking.grab_focus()


func _way_through_pages(event: InputEvent) -> int:
	if _is_one_of(event, KEY_PAGEUP, JOY_BUTTON_LEFT_SHOULDER):
		return -1
	if _is_one_of(event, KEY_PAGEDOWN, JOY_BUTTON_RIGHT_SHOULDER):
		return 1
	var key := event as InputEventKey
	if key != null and key.keycode == KEY_TAB and key.ctrl_pressed:
		return -1 if key.shift_pressed else 1
	return 0


func _is_one_of(event: InputEvent, key: Key, button: JoyButton) -> bool:
	if event is InputEventJoypadButton:
		return (event as InputEventJoypadButton).button_index == button
	return event is InputEventKey and (event as InputEventKey).keycode == key
