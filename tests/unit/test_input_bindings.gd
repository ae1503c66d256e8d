# SPDX-License-Identifier: MIT
extends GutTest
## Keys and buttons can be given to other actions, clashes are found, and nobody is locked out.

var _bindings: InputBindings


func before_each() -> void:
	_bindings = InputBindings.new()


func after_all() -> void:
	InputBindings.new().apply()


func _own_actions() -> Array[StringName]:
	var actions: Array[StringName] = []
	for action in InputMap.get_actions():
		if not action.begins_with("ui_") and not action.begins_with("spatial_editor"):
			actions.append(action)
	return actions


func test_every_action_of_the_project_is_listed_or_fixed() -> void:
	for action in _own_actions():
		var listed := ActionList.actions().has(action)
		assert_ne(listed, ActionList.FIXED.has(action), "%s: listed or fixed" % action)
	for row in ActionList.ROWS:
		if row.size() > 1:
			var action: StringName = row[0]
			assert_true(InputMap.has_action(action), "%s is in the input map" % action)


func test_all_that_the_project_binds_can_be_said() -> void:
	var count := 0
	for action in _own_actions():
		for event in InputMap.action_get_events(action):
			var words := BindingText.of(event)
			var again := BindingText.to_event(words)
			assert_not_null(again, "%s of %s" % [words, action])
			if again != null:
				assert_true(again.is_match(event), words)
				assert_eq(BindingText.of(again), words)
				assert_ne(BindingNames.of_event(event), "", "%s has a name" % words)
			count += 1
	assert_gt(count, 80)


func test_words_that_mean_nothing() -> void:
	for words: String in [
		"", "F", "key:", "key:Nowhere", "pad:q", "axis:left_x", "axis:+", "mouse:left"
	]:
		assert_null(BindingText.to_event(words), words)


func test_mouse_buttons_that_the_view_needs_cannot_be_bound() -> void:
	var click := InputEventMouseButton.new()
	click.button_index = MOUSE_BUTTON_LEFT
	assert_false(_bindings.bind(&"toggle_flight", click))
	click.button_index = MOUSE_BUTTON_MIDDLE
	assert_true(_bindings.bind(&"toggle_flight", click))
	var has := _bindings.events_of(&"toggle_flight", InputBindings.Device.MOUSE)
	assert_eq(has.size(), 1)


func test_another_key_takes_the_place_of_the_old_one_alone() -> void:
	assert_true(_bindings.bind(&"toggle_flight", DeviceInput.key(KEY_U)))
	assert_eq(_bindings.words_of(&"toggle_flight"), PackedStringArray(["pad:a", "key:U"]))
	_bindings.apply()
	assert_true(InputMap.event_is_action(DeviceInput.key(KEY_U), &"toggle_flight"))
	assert_false(InputMap.event_is_action(DeviceInput.key(KEY_F), &"toggle_flight"))
	assert_true(InputMap.event_is_action(DeviceInput.button(JOY_BUTTON_A), &"toggle_flight"))


func test_as_at_first_again() -> void:
	_bindings.bind(&"toggle_flight", DeviceInput.key(KEY_U))
	_bindings.bind(&"toggle_map", DeviceInput.key(KEY_Y))
	_bindings.reset(&"toggle_flight")
	assert_false(_bindings.is_changed(&"toggle_flight"))
	assert_true(_bindings.is_changed(&"toggle_map"))
	_bindings.reset_all()
	assert_eq(_bindings.to_json(), {})
	_bindings.apply()
	assert_true(InputMap.event_is_action(DeviceInput.key(KEY_F), &"toggle_flight"))
	assert_true(InputMap.event_is_action(DeviceInput.key(KEY_M), &"toggle_map"))


func test_binding_what_it_had_is_no_change() -> void:
	_bindings.clear(&"toggle_map", InputBindings.Device.KEYBOARD)
	assert_eq(_bindings.words_of(&"toggle_map").size(), 0)
	_bindings.bind(&"toggle_map", DeviceInput.key(KEY_M))
	assert_eq(_bindings.to_json(), {})


func test_changes_are_kept_as_plain_data() -> void:
	_bindings.bind(&"toggle_flight", DeviceInput.key(KEY_U))
	var motion := InputEventJoypadMotion.new()
	motion.axis = JOY_AXIS_LEFT_Y
	motion.axis_value = -0.8
	_bindings.bind(&"fly_up", motion)
	_bindings.clear(&"toggle_disk", InputBindings.Device.KEYBOARD)
	var text := JSON.stringify(_bindings.to_json())
	var data: Dictionary = JSON.parse_string(text)
	assert_eq(data["fly_up"], ["key:E", "axis:left_y-"])
	var faults: Array[String] = []
	var again := InputBindings.from_json(data, faults)
	assert_eq(faults.size(), 0)
	assert_eq(again.to_json(), _bindings.to_json())


func test_the_projects_bindings_do_not_clash() -> void:
	for action in ActionList.actions():
		for words in _bindings.words_of(action):
			var rivals := _bindings.rivals(action, words)
			assert_eq(rivals.size(), 0, "%s of %s: also %s" % [words, action, rivals])


func test_a_clash_is_found_where_both_count() -> void:
	_bindings.bind(&"toggle_map", DeviceInput.key(KEY_W))
	assert_eq(_bindings.rivals(&"toggle_map", "key:W"), [&"fly_forward"] as Array[StringName])
	assert_eq(_bindings.rivals(&"fly_forward", "key:W"), [&"toggle_map"] as Array[StringName])
	# Going round and flying are never at the same time.
	_bindings.bind(&"fly_up", DeviceInput.key(KEY_PAGEUP))
	assert_eq(_bindings.rivals(&"fly_up", "key:PageUp").size(), 0)
	# On a ride the press is for the ride.
	_bindings.bind(&"toggle_names", DeviceInput.key(KEY_SPACE))
	assert_eq(_bindings.rivals(&"toggle_names", "key:Space").size(), 0)
	# But not for what is held.
	_bindings.bind(&"ride_pause", DeviceInput.key(KEY_A))
	assert_eq(_bindings.rivals(&"ride_pause", "key:A"), [&"fly_left"] as Array[StringName])


func test_nobody_is_locked_out() -> void:
	var menus: Dictionary[StringName, Array] = {}
	for action in InputMap.get_actions():
		if action.begins_with("ui_") or ActionList.FIXED.has(action):
			menus[action] = InputMap.action_get_events(action)
	assert_true(menus.has(&"toggle_menu"))
	assert_false(
		_bindings.bind(&"toggle_map", DeviceInput.key(KEY_ESCAPE)), "Escape opens the menu"
	)
	assert_false(_bindings.bind(&"toggle_map", DeviceInput.button(JOY_BUTTON_START)))
	assert_false(_bindings.bind(&"toggle_menu", DeviceInput.key(KEY_U)))
	assert_false(_bindings.bind(&"ui_accept", DeviceInput.key(KEY_U)))
	_bindings.clear(&"toggle_menu", InputBindings.Device.KEYBOARD)
	_bindings.clear(&"ui_cancel", InputBindings.Device.KEYBOARD)
	for action in ActionList.actions():
		for device: InputBindings.Device in InputBindings.Device.values():
			_bindings.clear(action, device)
	_bindings.apply()
	for action in menus:
		assert_eq(InputMap.action_get_events(action), menus[action], action)
	var faults: Array[String] = []
	InputBindings.from_json({"toggle_menu": [], "ui_cancel": []}, faults).apply()
	assert_eq(faults.size(), 2, "nor by the file")
	for action in menus:
		assert_eq(InputMap.action_get_events(action), menus[action], action)
