# SPDX-License-Identifier: MIT
extends GutTest
## Truth and null.


func test_pass_truth() -> void:
	assert_true(true)
	assert_false(false, "text")


func test_fail_true() -> void:
	assert_true(false)


func test_fail_true_is_not_truthy() -> void:
	assert_true(1)


func test_fail_true_of_string() -> void:
	assert_true("yes")


func test_fail_false() -> void:
	assert_false(true)


func test_fail_false_is_not_falsy() -> void:
	assert_false(null)


func test_pass_null() -> void:
	assert_null(null)
	assert_not_null(0)
	assert_not_null(self)


func test_fail_null() -> void:
	assert_null(0)


func test_fail_not_null() -> void:
	assert_not_null(null)
