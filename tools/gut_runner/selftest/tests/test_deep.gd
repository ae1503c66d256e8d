# SPDX-License-Identifier: MIT
extends GutTest
## Equal down to the elements; the same or only equal.


func test_pass_deep() -> void:
	assert_eq_deep({"a": {"b": [1, 2]}}, {"a": {"b": [1, 2]}})
	assert_eq_deep([1, [2, 3]], [1, [2, 3]])
	assert_ne_deep([1, [2, 3]], [1, [2, 4]])


func test_fail_eq_deep() -> void:
	assert_eq_deep({"a": {"b": [1, 2]}}, {"a": {"b": [1, 3]}})


func test_fail_eq_deep_int_against_float() -> void:
	assert_eq_deep([1], [1.0])


func test_fail_eq_deep_key_missing() -> void:
	assert_eq_deep({"a": 1}, {"a": 1, "b": 2})


func test_fail_ne_deep() -> void:
	assert_ne_deep([1, [2, 3]], [1, [2, 3]])


func test_pass_same() -> void:
	var one: Array[int] = [1]
	var other: Array[int] = one
	assert_same(one, other)
	assert_not_same(one, [1])


func test_fail_same() -> void:
	assert_same([1], [1])


func test_fail_not_same() -> void:
	var one: Dictionary = {}
	assert_not_same(one, one)


func test_pass_eq_deep_of_plain_values() -> void:
	assert_eq_deep(1, 1.0)
