# SPDX-License-Identifier: MIT
extends GutTest
## The exhibit's settings: defaults, what is wrong by name, and that the exhibit starts whatever is
## in the file; the operator's PIN.

const FILE: String = "res://scenes/kiosk/config/kiosk.schema.json"

var _folder: ScratchFolder


func before_each() -> void:
	_folder = ScratchFolder.new("kiosk_config")


func after_each() -> void:
	_folder = null


func test_defaults_are_what_the_schema_allows() -> void:
	var schema: Dictionary = (load(FILE) as JSON).data
	var keys: Dictionary = schema["properties"]
	var defaults := {}
	for key: String in keys:
		var own: Dictionary = keys[key]
		assert_true(own.has("description"), key)
		defaults[key] = own["default"]
	assert_eq(JsonSchema.from_data(schema).check(defaults), "")
	var config := KioskConfig.from_data(defaults)
	assert_eq(config.complaints.size(), 0, "\n".join(config.complaints))
	assert_eq(config.text("mode"), "auto")
	assert_eq(config.whole("daily_restart_hour"), 4)
	assert_eq(config.get_log_folder(), KioskConfig.LOG_FOLDER)


func test_what_is_set_counts() -> void:
	var file := _folder.write_text(
		"kiosk.json",
		'{"mode": "screen", "idle_seconds": 45, "languages": ["en"], "language": "en"}'
	)
	var config := KioskConfig.from_file(file)
	assert_eq(config.complaints.size(), 0, "\n".join(config.complaints))
	assert_eq(config.text("mode"), "screen")
	assert_eq(config.number("idle_seconds"), 45.0)
	assert_eq(config.list("languages"), PackedStringArray(["en"]))


func test_each_wrong_key_is_named_and_the_others_count() -> void:
	var wrong: Dictionary[String, String] = {
		"mode": '"telescope"',
		"idle_seconds": "3",
		"visit_minutes": '"long"',
		"languages": '["de", "tlh"]',
		"language": '"fr"',
		"pin": '"12"',
		"tour": '"res://nowhere.tres"',
		"operator_hotkey": '"Nokey+F99"',
		"daily_restart_hour": "4.5",
		"color": "1",
	}
	for key in wrong:
		var file := _folder.write_text(
			"kiosk.json", '{"%s": %s, "volume": 0.25}' % [key, wrong[key]]
		)
		var config := KioskConfig.from_file(file)
		assert_eq(config.complaints.size(), 1, key + ": " + "\n".join(config.complaints))
		for word: String in [file, key]:
			assert_string_contains(config.complaints[0], word)
		assert_eq(config.number("volume"), 0.25, "the rest counts")
	assert_eq(KioskConfig.from_data({"mode": "telescope"}).text("mode"), "auto")


func test_what_is_no_settings_file_leaves_the_defaults() -> void:
	var broken: Array[PackedByteArray] = [
		"".to_utf8_buffer(),
		'{"mode": "scr'.to_utf8_buffer(),
		"[1, 2]".to_utf8_buffer(),
		PackedByteArray([0, 255, 254, 123]),
	]
	for bytes in broken:
		var config := KioskConfig.from_file(_folder.write_bytes("kiosk.json", bytes))
		assert_eq(config.complaints.size(), 1)
		assert_string_contains(config.complaints[0], "kiosk.json")
		assert_eq(config.text("mode"), "auto")
	assert_string_contains(KioskConfig.from_file("user://none.json").complaints[0], "none.json")


func test_where_it_is_looked_for() -> void:
	assert_eq(KioskConfig.find([], ""), "user://kiosk.json")
	assert_eq(KioskConfig.find([], "/opt/sky"), "/opt/sky/kiosk.json")
	var named: PackedStringArray = ["--kiosk", "--kiosk-config=/etc/sky.json"]
	assert_eq(KioskConfig.find(named, "/opt/sky"), "/etc/sky.json")


func test_the_pin_is_not_told() -> void:
	var config := KioskConfig.from_data({"pin": "4711"})
	assert_false(config.describe().contains("4711"))
	assert_string_contains(config.describe(), "idle_seconds")


func test_pins() -> void:
	var hashed := {"salt": "sea", "sha256": "sea4711".sha256_text()}
	for setting: Variant in ["4711", hashed]:
		var config := KioskConfig.from_data({"pin": setting})
		assert_eq(config.complaints.size(), 0)
		var pin := config.get_pin()
		assert_true(pin.is_set())
		assert_true(pin.accepts("4711", 0.0))
		assert_false(pin.accepts("4712", 0.0))
		assert_false(pin.accepts("4711", 1.0), "one has to wait")
		assert_true(pin.accepts("4711", OperatorPin.FIRST_WAIT + 0.1))
	assert_false(KioskConfig.from_data({}).get_pin().is_set())


func test_waits_grow_but_not_for_ever() -> void:
	var pin := OperatorPin.from_setting("4711")
	var now := 0.0
	var last := 0.0
	for i in 12:
		assert_false(pin.accepts("0000", now))
		var wait := pin.get_wait(now)
		assert_true(wait > last or wait == OperatorPin.LONGEST_WAIT)
		last = wait
		now += wait
	assert_eq(last, OperatorPin.LONGEST_WAIT)
	assert_true(pin.accepts("4711", now))
	pin.accepts("0000", now)
	assert_eq(pin.get_wait(now), OperatorPin.FIRST_WAIT, "the right one makes up for it")
