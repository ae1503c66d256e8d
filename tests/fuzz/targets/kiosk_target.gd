# SPDX-License-Identifier: MIT
extends FuzzTarget
## The settings of the exhibit. Whatever is in the file, there are settings, and the schema allows
## them.

var _schema := JsonSchema.from_file(KioskConfig.SCHEMA_FILE)


func _init() -> void:
	file_name = "kiosk.json"
	is_json = true


func seeds() -> Array[PackedByteArray]:
	var schema: Dictionary = (load(KioskConfig.SCHEMA_FILE) as JSON).data
	var keys: Dictionary = schema["properties"]
	var defaults := {}
	for key: String in keys:
		defaults[key] = keys[key]["default"]
	return [
		json(defaults),
		json({"mode": "screen", "idle_seconds": 45, "languages": ["en"], "language": "en"}),
		json({"pin": {"salt": "sea", "sha256": "sea4711".sha256_text()}, "volume": 0.5}),
		json({"pin": "4711", "operator_hotkey": "Ctrl+F5", "tour": "res://nowhere.tres"}),
	]


func read(path: String) -> FuzzAnswer:
	var answer := FuzzAnswer.new()
	var config := KioskConfig.from_file(path)
	answer.complain(config.complaints, path)
	var told: Variant = JSON.parse_string(config.describe())
	answer.demand(told is Dictionary, "settings that can be told")
	var values: Dictionary = told if told is Dictionary else {}
	values["pin"] = ""
	var fault := _schema.check(values)
	answer.demand(fault.is_empty(), "settings within the schema: " + fault)
	answer.demand(config.list("languages").has(config.text("language")), "a language that there is")
	answer.demand(config.get_log_bytes() > 0, "a log with room")
	config.get_pin().accepts("0000", 0.0)
	return answer
