# SPDX-License-Identifier: MIT
extends GutTest
## Every action can be reached by keyboard and by gamepad, and the help can name both.

const SOURCES: PackedStringArray = [
	"res://scenes/desktop/motion/view_controls.gd", "res://scenes/desktop/desktop.gd"
]


func _explained() -> Array[StringName]:
	var actions: Array[StringName] = []
	for row in HelpOverlay.ROWS:
		if not row.is_empty():
			var listed: Array = row[1]
			actions.append_array(listed)
	return actions


func _project_actions() -> Array[StringName]:
	var actions: Array[StringName] = []
	for action in InputMap.get_actions():
		if not action.begins_with("ui_") and not action.begins_with("spatial_editor"):
			actions.append(action)
	return actions


func test_help_explains_every_action_of_the_project() -> void:
	var explained := _explained()
	assert_gt(explained.size(), 20)
	for action in explained:
		assert_true(InputMap.has_action(action), "%s is in the input map" % action)


func test_every_action_in_the_scripts_is_in_the_input_map_and_explained() -> void:
	var explained := _explained()
	var pattern := RegEx.create_from_string('&"([a-z]+_[a-z_]+|approach|recede)"')
	var found := 0
	for source in SOURCES:
		for hit in pattern.search_all(FileAccess.get_file_as_string(source)):
			var action := StringName(hit.get_string(1))
			found += 1
			assert_true(InputMap.has_action(action), "%s in %s" % [action, source])
			assert_has(explained, action, "%s is explained" % action)
	assert_gt(found, 30)


func test_every_explained_action_has_a_key_and_a_gamepad_control() -> void:
	# These have an item in the menu, or a switch in the panel.
	var without: Array[StringName] = [
		&"toggle_help",
		&"toggle_names",
		&"toggle_overlays",
		&"toggle_map",
		&"toggle_disk",
		&"next_disk",
	]
	for action in _explained():
		assert_ne(BindingNames.keyboard([action]), "", "key of %s" % action)
		if not without.has(action):
			assert_ne(BindingNames.gamepad([action]), "", "gamepad control of %s" % action)


func test_no_key_does_two_things_at_once() -> void:
	# Turning shares its keys: one way round the hole, the other in flight. So do the triggers.
	var seen: Dictionary[int, StringName] = {}
	# What a key does on a ride may be explained in a row of its own.
	for action in _explained():
		if action.begins_with("look_") or seen.values().has(action):
			continue
		for event in InputMap.action_get_events(action):
			if event is InputEventKey:
				var key := (event as InputEventKey).physical_keycode
				if key == KEY_NONE:
					key = (event as InputEventKey).keycode
				assert_false(seen.has(key), "%s: key %d, %s" % [action, key, seen.get(key, &"")])
				seen[key] = action


func test_names_are_given_once() -> void:
	var turns: Array[StringName] = [&"orbit_left", &"orbit_right", &"orbit_up", &"orbit_down"]
	assert_eq(BindingNames.keyboard(turns), "Arrow keys")
	assert_eq(BindingNames.gamepad(turns), "Right stick")
	assert_eq(BindingNames.keyboard([&"toggle_flight"]), "F")
	assert_eq(BindingNames.gamepad([&"toggle_flight"]), "A")
