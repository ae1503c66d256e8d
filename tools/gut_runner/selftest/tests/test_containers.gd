# SPDX-License-Identifier: MIT
extends GutTest
## Arrays and dictionaries.


func test_pass_eq_by_value() -> void:
	assert_eq([1, 2, 3], [1, 2, 3])
	assert_eq({"a": 1, "b": [2]}, {"a": 1, "b": [2]})
	assert_eq(PackedFloat32Array([1, 2]), PackedFloat32Array([1, 2]))
	assert_ne([1, 2], [1, 3])
	assert_ne({"a": 1}, {"a": 2})


func test_fail_eq_array() -> void:
	assert_eq([1, "two", 3], [1, 2, 3, 4])


func test_fail_eq_dictionary() -> void:
	assert_eq({"a": 1}, {"a": 2})


func test_fail_ne_array() -> void:
	assert_ne([1], [1])


func test_fail_eq_array_against_packed() -> void:
	assert_eq([1], PackedInt32Array([1]))


func test_pass_has() -> void:
	assert_has([1, 2, "four"], "four")
	assert_has({"one": 1}, "one")
	assert_has(PackedInt32Array([1, 2]), 2)
	assert_does_not_have([1, 2], 3)
	assert_does_not_have({"one": 1}, 1)


func test_fail_has_array() -> void:
	assert_has([1, 2], 5)


func test_fail_has_looks_at_keys() -> void:
	assert_has({"one": "two"}, "two")


func test_fail_does_not_have() -> void:
	assert_does_not_have([1, 2], 2)


func test_fail_eq_array_int_against_float() -> void:
	assert_eq([1], [1.0])


func test_fail_eq_dictionary_int_against_float() -> void:
	assert_eq({"a": 1}, {"a": 1.0})


func test_pass_eq_typed_array() -> void:
	var typed: Array[int] = [1]
	assert_eq(typed, [1])
	assert_eq_deep(typed, [1])
