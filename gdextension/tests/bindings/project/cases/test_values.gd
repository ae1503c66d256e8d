# SPDX-License-Identifier: MIT
## Values through the fast path (typed calls) and through Variants (dynamic calls).
extends "res://cases/provider_case.gd"

var _calls := ProbeCalls.new()


func test_numbers_come_back() -> void:
	equal(_calls.pass_bool(true), true, "bool")
	equal(_calls.pass_int32(-2147483648), -2147483648, "int32")
	equal(_calls.pass_uint8(255), 255, "uint8")
	equal(_calls.pass_int64(-9007199254740993), -9007199254740993, "int64")
	equal(_calls.pass_double(0.1), 0.1, "double")
	equal(_calls.pass_float(0.1), 0.10000000149011612, "float is rounded to 24 bits")


func test_values_come_back_from_dynamic_calls() -> void:
	var values := {
		"pass_bool": false,
		"pass_int32": 7,
		"pass_int64": 1 << 62,
		"pass_double": -1.5,
		"pass_string": "grüß 🌌",
		"pass_string_name": &"interned",
		"pass_vector2": Vector2(1, -2),
		"pass_vector3": Vector3(1, 2, 3),
		"pass_color": Color(0.25, 0.5, 0.75, 0.125),
		"pass_transform": Transform3D(Basis(Vector3.UP, 0.5), Vector3(4, 5, 6)),
		"pass_array": [1, "two", [3.0]],
		"pass_dictionary": {"a": 1, 2: [3]},
		"pass_variant": PackedVector3Array([Vector3.ONE]),
	}
	for method: String in values:
		equal(_calls.call(method, values[method]), values[method], method)


func test_values_come_back_from_typed_calls() -> void:
	equal(_calls.pass_string("grüß 🌌"), "grüß 🌌", "String")
	equal(_calls.pass_string_name(&"interned"), &"interned", "StringName")
	equal(_calls.pass_vector2(Vector2(1, -2)), Vector2(1, -2), "Vector2")
	equal(_calls.pass_vector3(Vector3(1, 2, 3)), Vector3(1, 2, 3), "Vector3")
	equal(_calls.pass_color(Color(0.25, 0.5, 0.75, 0.125)), Color(0.25, 0.5, 0.75, 0.125), "Color")
	var turned := Transform3D(Basis(Vector3.UP, 0.5), Vector3(4, 5, 6))
	equal(_calls.pass_transform(turned), turned, "Transform3D")
	equal(_calls.pass_variant(null), null, "nil")
	equal(_calls.pass_variant(&"x"), &"x", "a Variant keeps its type")


func test_arrays_and_dictionaries_are_shared() -> void:
	var list: Array = [1]
	var back: Array = _calls.pass_array(list)
	back.append(2)
	equal(list, [1, 2], "the same array")
	var map := {"a": 1}
	var map_back: Dictionary = _calls.pass_dictionary(map)
	map_back["b"] = 2
	equal(map, {"a": 1, "b": 2}, "the same dictionary")


func test_conversions_the_engine_allows() -> void:
	equal(_calls.call("pass_double", 3), 3.0, "int to float")
	equal(_calls.call("pass_int64", 3.75), 3, "float to int")
	equal(_calls.call("pass_string", &"name"), "name", "StringName to String")
	equal(_calls.call("pass_string_name", "name"), &"name", "String to StringName")
	equal(_calls.call("pass_vector3", Vector3i(1, 2, 3)), Vector3(1, 2, 3), "Vector3i to Vector3")


func test_every_type_survives_a_variant() -> void:
	var wanted: Array = [
		true,
		-9007199254740993,
		0.1,
		"grüß 🌌",
		&"name",
		NodePath("a/b:c"),
		Vector2(1, 2),
		Vector2i(3, 4),
		Rect2(1, 2, 3, 4),
		Vector3(1, 2, 3),
		Vector3i(4, 5, 6),
		Vector4(1, 2, 3, 4),
		Quaternion.IDENTITY,
		AABB(Vector3(1, 2, 3), Vector3(4, 5, 6)),
		Basis(Vector3(0, 1, 0), Vector3(-1, 0, 0), Vector3(0, 0, 1)),
		Transform3D(Basis.IDENTITY, Vector3(7, 8, 9)),
		Color(0.25, 0.5, 0.75),
	]
	var got := _calls.convert_all()
	equal(got.size(), wanted.size(), "number of types")
	for index: int in wanted.size():
		equal(got[index], wanted[index], type_string(typeof(wanted[index])))


func test_text() -> void:
	equal(_calls.describe("pi", 3, 3.14159), "pi has 3 at 3.14", "vformat")
	var facts := _calls.text_facts("grüß 🌌")
	equal(facts["bytes"], 11, "bytes in UTF-8")
	equal(facts["again"], "grüß 🌌", "UTF-8 and back")
	equal(facts["joined"], "grüß 🌌!7", "concatenation")
	equal(facts["equal"], true, "comparison of texts")
	equal(facts["name_equal"], true, "comparison of names")
	equal(facts["path"], "res://a", "paths")


func test_vectors_and_matrices() -> void:
	var turn := Basis(Vector3.UP, PI / 2.0)
	var facts := _calls.vector_facts()
	check((facts["turned"] as Vector3).is_equal_approx(turn * Vector3(0, 0, 1)), "Basis.xform")
	check((facts["column"] as Vector3).is_equal_approx(turn.z), "Basis.get_column")
	check(
		(facts["identity"] as Transform3D).is_equal_approx(Transform3D.IDENTITY), "affine_inverse"
	)
	equal(facts["cross"], Vector3(0, 0, 1), "cross product")
	equal(facts["length"], 7.0, "length")
	equal(facts["determinant"], 24.0, "determinant")


func test_enumerations() -> void:
	equal(_calls.pass_mode(ProbeResource.MODE_ORBIT), 7, "value")
	equal(ClassDB.class_get_enum_list("ProbeResource", true), PackedStringArray(["Mode"]), "name")
	equal(
		ClassDB.class_get_enum_constants("ProbeResource", "Mode", true),
		PackedStringArray(["MODE_STATIC", "MODE_RAIN", "MODE_ORBIT"]),
		"constants"
	)
	var method := _method_of("ProbeCalls", "pass_mode")
	equal(method["return"]["class_name"], &"ProbeResource.Mode", "class name of the return value")
	equal(method["args"][0]["class_name"], &"ProbeResource.Mode", "class name of the argument")


func test_typed_arrays() -> void:
	var images := _calls.make_images(2)
	equal(images.size(), 2, "size")
	check(images.is_typed(), "the array is typed")
	equal(images.get_typed_class_name(), &"Image", "element class")
	equal((images[0] as Image).get_format(), Image.FORMAT_RGB8, "elements are usable")


func test_argument_names_are_known() -> void:
	var method := _method_of("ProbeCalls", "describe")
	var names: Array = method["args"].map(
		func(argument: Dictionary) -> String: return argument["name"]
	)
	equal(names, ["name", "number", "value"], "names")
	equal(method["args"][2]["type"], TYPE_FLOAT, "type")


func _method_of(type: String, method_name: String) -> Dictionary:
	for method: Dictionary in ClassDB.class_get_method_list(type, true):
		if method["name"] == method_name:
			return method
	failures.append("%s has no method %s" % [type, method_name])
	return {}
