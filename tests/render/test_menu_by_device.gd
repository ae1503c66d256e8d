# SPDX-License-Identifier: MIT
extends "res://tests/integration/desktop_test.gd"
## In a real window: the menu is opened, gone through and left with the keyboard alone and with the
## gamepad alone, by the events that these send.

const PAGES: Array[StringName] = [
	MainMenu.SETTINGS, MainMenu.CARDS, MainMenu.CONTROLS, MainMenu.CREDITS
]

var _menus: MenuDirector
var _menu: MainMenu
## A device: what opens the menu, goes down, accepts and cancels.
var _devices: Array = (
	ParameterFactory
	. named_parameters(
		["open", "down", "accept", "cancel"],
		[
			[
				_key_event(KEY_ESCAPE),
				_key_event(KEY_DOWN),
				_key_event(KEY_ENTER),
				_key_event(KEY_ESCAPE)
			],
			[
				_button_event(JOY_BUTTON_START),
				_button_event(JOY_BUTTON_DPAD_DOWN),
				_button_event(JOY_BUTTON_A),
				_button_event(JOY_BUTTON_B)
			],
		]
	)
)

@warning_ignore("untyped_declaration")
func should_skip_script():
	if RenderingServer.get_current_rendering_method() == "mobile":
		return false
	return "texts and menus are the same in every renderer"


func before_each() -> void:
	super()
	_menus = _scene.get_node("Menus")
	_menu = _scene.get_node("%MainMenu")
	_menus.quit_asked.disconnect(_scene.quit)


func _focused() -> Control:
	return get_tree().root.gui_get_focus_owner()


# Goes down to an item of the open menu.
func _go_to(item: StringName, down: InputEvent) -> void:
	for step in _menu.get_items().size():
		if _focused() == _menu.get_button(item):
			return
		_press(down)


func test_every_item_is_reached_and_used_by_each_device(
	p: Variant = use_parameters(_devices)
) -> void:
	var open: InputEvent = p.open
	var down: InputEvent = p.down
	var accept: InputEvent = p.accept
	var cancel: InputEvent = p.cancel
	watch_signals(_menus)
	watch_signals(_menu)
	for item in _menu.get_items():
		_press(open)
		assert_true(_menu.visible, "the menu opens for %s" % item)
		_go_to(item, down)
		assert_eq(_focused(), _menu.get_button(item), "%s is reached" % item)
		_press(accept)
		assert_signal_emitted_with_parameters(_menu, "chosen", [item])
		if PAGES.has(item):
			assert_true(_menus.is_page_open(), "%s opens" % item)
			assert_not_null(_focused(), "%s has a focus" % item)
			_press(cancel)
			assert_false(_menus.is_page_open(), "%s closes" % item)
			assert_true(_menu.visible, "back in the menu from %s" % item)
		if _menu.visible:
			_press(cancel)
		assert_false(_menu.visible, "the menu is left after %s" % item)
		_put_back()
	assert_signal_emit_count(_menus, "quit_asked", 1)


# What an item has begun ends.
func _put_back() -> void:
	(_scene.get_node("%Panel") as SkyPanel).hide()
	(_scene.get_node("%PhotoMode") as PhotoMode).close()
	(_scene.get_node("%TourGuide") as TourGuide).leave()


func test_the_visit_rests_behind_the_menu() -> void:
	var rides: RideDirector = _scene.get_node("Rides")
	rides.start(RideDirector.Kind.FROM_REST)
	_press(_key_event(KEY_ESCAPE))
	var time := rides.ride.get_proper_time()
	await wait_process_frames(3)
	assert_eq(rides.ride.get_proper_time(), time)
	assert_false(_controls.listening)
	_press(_key_event(KEY_ESCAPE))
	await wait_process_frames(3)
	assert_gt(rides.ride.get_proper_time(), time)
	assert_true(_controls.listening)


func test_the_title_stays_until_something_is_chosen() -> void:
	_scene.show_title()
	_press(_key_event(KEY_ESCAPE))
	assert_true(_menu.visible)
	_press(_key_event(KEY_ENTER))
	assert_false(_menu.visible, "Explore begins")


func test_an_exhibit_cannot_be_left() -> void:
	_menu.can_quit = false
	_press(_key_event(KEY_ESCAPE))
	assert_false(_menu.get_button(MainMenu.QUIT).visible)
