# SPDX-License-Identifier: MIT
extends GutTest
## Shots good and bad, the same that tools/setup/test_shot_schema.py shows to another validator.

const FOLDER: String = "res://tests/data/shots"

var _schema := JsonSchema.from_file(ShotSpec.SCHEMA_FILE)
var _accepted := _read("accepted.json")
var _against_schema := _read("against_schema.json")
var _impossible := _read("impossible.json")


func test_the_schema_is_within_the_subset() -> void:
	assert_eq(_schema.error, "")


func test_accepted_shots(shot: Dictionary = use_parameters(_accepted)) -> void:
	assert_eq(_schema.check(shot), "")
	assert_eq(ShotSpec.from_data(shot).error, "")


func test_shots_against_the_schema(entry: Dictionary = use_parameters(_against_schema)) -> void:
	var says: String = entry["says"]
	assert_string_contains(_schema.check(entry["shot"]), says)
	assert_string_contains(ShotSpec.from_data(entry["shot"]).error, says)


func test_shots_that_cannot_be(entry: Dictionary = use_parameters(_impossible)) -> void:
	var says: String = entry["says"]
	assert_eq(_schema.check(entry["shot"]), "", "the schema alone cannot know")
	assert_string_contains(ShotSpec.from_data(entry["shot"]).error, says)


func test_numbers_that_json_has_not() -> void:
	for number: float in [NAN, INF, -INF]:
		for shot: Dictionary in [
			{"position_rs": [0, number, 1]},
			{"position_rs": [0, 0, 10], "vertical_fov_deg": number},
			{"position_rs": [0, 0, 10], "stars": {"orders": number}},
			{"position_rs": [0, 0, 10], "exposure": number},
		]:
			var key: String = shot.keys().back()
			assert_string_starts_with(_schema.check(shot), key)


func test_defaults_are_what_the_schema_says() -> void:
	var file := load(ShotSpec.SCHEMA_FILE) as JSON
	var schema: Dictionary = file.data
	var properties: Dictionary = schema["properties"]
	var plain := ShotSpec.from_data({"position_rs": [0, 0, 10]})
	for key: String in properties:
		var property: Dictionary = properties[key]
		if property.has("default"):
			var spec := ShotSpec.from_data({"position_rs": [0, 0, 10], key: property["default"]})
			_expect_same(spec, plain, key)
	properties = properties["stars"]["properties"]
	for key: String in properties:
		var stars := {key: properties[key]["default"]}
		var spec := ShotSpec.from_data({"position_rs": [0, 0, 10], "stars": stars})
		_expect_same(spec, plain, "stars." + key)


func _expect_same(spec: ShotSpec, plain: ShotSpec, key: String) -> void:
	for property in spec.get_property_list():
		var field: String = property["name"]
		var is_value: bool = int(property["type"]) != TYPE_OBJECT and field != "renderer_named"
		if int(property["usage"]) & PROPERTY_USAGE_SCRIPT_VARIABLE and is_value:
			assert_eq(spec.get(field), plain.get(field), "%s with the default of %s" % [field, key])


func _read(file_name: String) -> Array:
	var read: Variant = JSON.parse_string(
		FileAccess.get_file_as_string(FOLDER.path_join(file_name))
	)
	return read if read is Array else []
