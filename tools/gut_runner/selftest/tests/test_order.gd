# SPDX-License-Identifier: MIT
extends GutTest
## Order and ranges.


func test_pass_order() -> void:
	assert_gt(5, 0)
	assert_gt("b", "a")
	assert_gt(1.1, 1)
	assert_gte(5, 5)
	assert_gte(1.1, 1)
	assert_lt(-5, 0, "text")
	assert_lt(99, 100.5)
	assert_lte(-5, -5)


func test_fail_gt_equal() -> void:
	assert_gt(1.0, 1)


func test_fail_gt_less() -> void:
	assert_gt(0, 5)


func test_fail_gte() -> void:
	assert_gte(0.9, 1.0)


func test_fail_lt_equal() -> void:
	assert_lt(-5, -5)


func test_fail_lt_types_differ() -> void:
	assert_lt("a", 5)


func test_fail_lte() -> void:
	assert_lte(2, 1)


func test_fail_gt_nan() -> void:
	assert_gt(NAN, 1.0)


func test_fail_lt_nan() -> void:
	assert_lt(NAN, 1.0)


func test_pass_between() -> void:
	assert_between(5, 0, 10)
	assert_between(10, 0, 10)
	assert_between(0, 0, 10)
	assert_between(2.25, 2, 4.0)
	assert_not_between(1, 5, 10)
	assert_not_between(10, 0, 10)
	assert_not_between(-2, -2, 10)


func test_fail_between_below() -> void:
	assert_between(1, 5, 10)


func test_fail_between_above() -> void:
	assert_between(10.5, 5, 10)


func test_fail_between_ends_swapped() -> void:
	assert_between(5, 10, 0)


func test_fail_not_between() -> void:
	assert_not_between(0.25, -2.0, 4.0)


func test_fail_gt_null() -> void:
	assert_gt(1, null)


func test_fail_between_types_differ() -> void:
	assert_between("b", 0, 1)


func test_pass_between_texts() -> void:
	assert_between("b", "a", "c")
