# SPDX-License-Identifier: MIT
extends GutTest
## Settings are kept, and a file in any state does no harm.

var _folder: ScratchFolder
var _file: String
var _changes: Array[StringName] = []


func before_each() -> void:
	# The former one first takes its files along.
	_folder = null
	_folder = ScratchFolder.new("settings")
	_file = _folder.file("settings.json")
	_changes.clear()


func _open() -> UserSettings:
	var settings := UserSettings.new()
	settings.file = _file
	settings.changed.connect(_changes.append)
	add_child_autofree(settings)
	return settings


# What each setting can be besides what it is at first.
func _other(setting: Setting) -> Variant:
	match setting.kind:
		Setting.Kind.SWITCH:
			return setting.initial == false
		Setting.Kind.NUMBER:
			return setting.least if setting.initial != setting.least else setting.most
		Setting.Kind.CHOICE:
			return setting.choices[1 if setting.initial == setting.choices[0] else 0]
	return {"toggle_flight": ["key:U"]}


func test_the_list_is_sound() -> void:
	assert_gt(SettingList.keys().size(), 15)
	for key in SettingList.keys():
		var setting := SettingList.find(key)
		assert_eq(setting.key, key)
		assert_true(setting.takes(setting.initial), "%s takes its first value" % key)
		assert_true(setting.takes(_other(setting)), "%s takes another" % key)
		if setting.kind == Setting.Kind.CHOICE:
			assert_eq(setting.titles.size(), setting.choices.size(), "%s: a name each" % key)
		if setting.kind == Setting.Kind.NUMBER:
			var steps := (setting.most - setting.least) / setting.step
			assert_almost_eq(steps, roundf(steps), 1e-6, "%s: whole steps" % key)
			var initial: float = setting.initial
			var at := (initial - setting.least) / setting.step
			assert_almost_eq(at, roundf(at), 1e-6, "%s: the first value is one of them" % key)


func test_without_a_file_all_is_as_at_first() -> void:
	var settings := _open()
	for key in SettingList.keys():
		assert_true(settings.is_initial(key), key)
	assert_eq(settings.faults, [] as Array[String])
	settings.save()
	assert_false(FileAccess.file_exists(_file), "nothing changed, nothing written")


func test_everything_comes_back() -> void:
	var settings := _open()
	for key in SettingList.keys():
		settings.set_value(key, _other(SettingList.find(key)))
	assert_eq(_changes.size(), SettingList.keys().size())
	settings.save()
	var again := _open()
	assert_eq(again.faults, [] as Array[String])
	for key in SettingList.keys():
		assert_eq(again.get_value(key), _other(SettingList.find(key)), key)


func test_a_change_is_written_after_a_while() -> void:
	var settings := _open()
	settings.set_value(&"volume", 40.0)
	settings._process(0.3)
	settings.set_value(&"volume", 45.0)
	settings._process(0.3)
	assert_false(FileAccess.file_exists(_file), "while it still changes")
	settings._process(0.3)
	assert_true(FileAccess.file_exists(_file))
	var written := FileAccess.get_modified_time(_file)
	DirAccess.remove_absolute(_file)
	settings._process(10.0)
	assert_false(FileAccess.file_exists(_file), "once only")
	assert_gt(written, 0)


func test_a_change_is_written_when_the_scene_ends() -> void:
	var settings := _open()
	settings.set_value(&"volume", 40.0)
	remove_child(settings)
	assert_true(FileAccess.file_exists(_file))
	settings.free()
	assert_eq(_open().get_number(&"volume"), 40.0)


func test_a_change_is_written_when_the_window_closes() -> void:
	var settings := _open()
	settings.set_value(&"mute", true)
	settings.notification(NOTIFICATION_WM_CLOSE_REQUEST)
	assert_true(FileAccess.file_exists(_file))


func test_the_same_value_is_no_change() -> void:
	_open().set_value(&"mute", false)
	assert_eq(_changes, [] as Array[StringName])


func test_a_damaged_file_is_put_aside_and_all_goes_on() -> void:
	var whole := '{"volume": 40}'
	for damage: String in ["", whole.left(9), "[1, 2]", "no", "null", "{}{"]:
		AtomicFile.remove(_file)
		_folder.write_text("settings.json", damage)
		var settings := _open()
		assert_eq(settings.get_number(&"volume"), 100.0, damage)
		assert_eq(settings.faults.size(), 1, "told: %s" % damage)
		if settings.faults.size() == 1:
			assert_string_contains(settings.faults[0], "settings.damaged.json")
		var aside := _folder.file("settings.damaged.json")
		assert_eq(FileAccess.get_file_as_string(aside), damage, "kept for who wants to look")
		settings.set_value(&"volume", 50.0)
		settings.save()
		assert_eq(_open().get_number(&"volume"), 50.0)


func test_bytes_that_are_no_text_are_damage() -> void:
	_folder.write_bytes("settings.json", PackedByteArray([0xff, 0xfe, 0, 0x80, 0xc0]))
	assert_eq(_open().faults.size(), 1)


func test_a_damaged_file_gives_way_to_the_former_one() -> void:
	var settings := _open()
	settings.set_value(&"volume", 40.0)
	settings.save()
	settings.set_value(&"volume", 45.0)
	settings.save()
	_folder.write_text("settings.json", '{"vol')
	var again := _open()
	assert_eq(again.get_number(&"volume"), 40.0)
	assert_eq(again.faults.size(), 1)


func test_what_nobody_knows_is_told_by_name_and_left_out() -> void:
	_folder.write_text("settings.json", '{"volum": 3, "mute": true}')
	var settings := _open()
	assert_true(settings.is_on(&"mute"))
	assert_eq(settings.faults.size(), 1)
	assert_string_contains(settings.faults[0], "'volum'")
	assert_string_contains(settings.faults[0], "settings.json")


func test_a_wrong_value_costs_only_itself() -> void:
	var wrong: Dictionary[StringName, Array] = {
		&"quality": ["best", 1, true, null],
		&"volume": [-1, 101, "loud", true, [], {}],
		&"mute": [1, "yes", null],
		&"bindings": [[], "key:F", 3],
	}
	for key in wrong:
		for value: Variant in wrong[key]:
			var text := JSON.stringify({key: value, "caption_size": 150})
			_folder.write_text("settings.json", text)
			var settings := _open()
			assert_true(settings.is_initial(key), text)
			assert_eq(settings.get_number(&"caption_size"), 150.0, text)
			assert_eq(settings.faults.size(), 1, text)
			if settings.faults.size() == 1:
				assert_string_contains(settings.faults[0], "'%s'" % key)


func test_wrong_bindings_are_told() -> void:
	var bindings := {
		"fly": ["key:F"], "fly_up": ["key:Nowhere"], "fly_down": 3, "roll_left": ["key:U"]
	}
	_folder.write_text("settings.json", JSON.stringify({"bindings": bindings}))
	var settings := _open()
	assert_eq(settings.faults.size(), 3)
	assert_eq(settings.get_value(&"bindings"), {"roll_left": ["key:U"]})


func test_a_page_is_reset_alone() -> void:
	var settings := _open()
	settings.set_value(&"volume", 40.0)
	settings.set_value(&"high_contrast", true)
	settings.reset_page(SettingList.SOUND)
	assert_true(settings.is_initial(&"volume"))
	assert_true(settings.is_on(&"high_contrast"))


func test_nothing_is_kept_without_a_file() -> void:
	var settings := UserSettings.new()
	settings.file = ""
	add_child_autofree(settings)
	settings.set_value(&"volume", 40.0)
	settings.save()
	assert_eq(settings.get_number(&"volume"), 40.0)
