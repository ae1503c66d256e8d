# SPDX-License-Identifier: MIT
extends GutTest
## Strings.


func test_pass_strings() -> void:
	assert_string_contains("abc 123", "c 1")
	assert_string_contains("abc 123", "BC", false)
	assert_string_starts_with("abc 123", "a")
	assert_string_starts_with("abc 123", "ABC", false)
	assert_string_ends_with("abc 123", "123")
	assert_string_ends_with("abc 123", "C 123", false)


func test_fail_string_contains_case() -> void:
	assert_string_contains("abc 123", "BC")


func test_fail_string_contains_nothing() -> void:
	assert_string_contains("abc", "")


func test_fail_string_starts_with() -> void:
	assert_string_starts_with("abc 123", "bc")


func test_fail_string_starts_with_case() -> void:
	assert_string_starts_with("abc 123", "ABC")


func test_fail_string_ends_with() -> void:
	assert_string_ends_with("abc 123", "12")


func test_fail_string_contains_not_a_string() -> void:
	assert_string_contains(["abc"], "abc")


func test_fail_string_contains_string_name() -> void:
	assert_string_contains(&"abc", "b")


func test_fail_has_of_string() -> void:
	assert_has("abc", "b")
