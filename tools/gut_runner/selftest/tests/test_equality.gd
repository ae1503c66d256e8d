# SPDX-License-Identifier: MIT
extends GutTest
## Equality of plain values. The name of each test says what its outcome must be.


func test_pass_eq() -> void:
	assert_eq(1, 1)
	assert_eq("a", "a", "text")
	assert_eq(1.5, 1.5)
	assert_eq(Vector3(1, 2, 3), Vector3(1, 2, 3))
	assert_eq(null, null)
	assert_eq(true, true)


func test_pass_eq_int_against_float() -> void:
	assert_eq(1, 1.0)


func test_pass_eq_string_name() -> void:
	assert_eq("a", &"a")
	assert_eq(&"a", "a")


func test_pass_eq_against_null_is_a_comparison() -> void:
	assert_ne(1, null)


func test_fail_eq_against_null() -> void:
	assert_eq(1, null)


func test_fail_eq_int() -> void:
	assert_eq(1, 2)


func test_fail_eq_types_differ() -> void:
	assert_eq("1", 1)


func test_fail_eq_bool_against_int() -> void:
	assert_eq(true, 1)


func test_fail_eq_vector() -> void:
	assert_eq(Vector2(1, 2), Vector2(1, 3))


func test_fail_eq_nan() -> void:
	assert_eq(NAN, NAN)


func test_pass_ne() -> void:
	assert_ne(1, 2)
	assert_ne("one", "two")
	assert_ne(NAN, NAN)


func test_fail_ne() -> void:
	assert_ne(2, 2)


func test_fail_ne_types_differ() -> void:
	assert_ne("2", 2)


func test_fail_eq_vector_types_differ() -> void:
	assert_eq(Vector2(1, 1), Vector2i(1, 1))
