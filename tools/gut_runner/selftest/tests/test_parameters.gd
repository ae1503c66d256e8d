# SPDX-License-Identifier: MIT
extends GutTest
## One test called for many values.

var _seen: Array = []
var _before: int = 0
var _named: Array = ParameterFactory.named_parameters(
	["radius", "expected"], [[1.5, 3.0], [3.0, 6.0], [4.0, 8.0]]
)
var _short: Array = ParameterFactory.named_parameters(["a", "b"], [[1], "odd", ["x", "y", "z"]])


func before_each() -> void:
	_before += 1


func test_pass_1_each(value: int = use_parameters([1, 2, 3])) -> void:
	_seen.append(value)
	assert_gt(value, 0)


func test_pass_2_each_was_called() -> void:
	assert_eq(_seen, [1, 2, 3])


func test_pass_3_before_each_runs_for_each() -> void:
	assert_eq(_before, 5)


func test_pass_named(p: Dictionary = use_parameters(_named)) -> void:
	assert_almost_eq(p.radius * 2.0, p.expected, 1e-9)


func test_pass_named_fills_up() -> void:
	assert_eq(_short, [{"a": 1, "b": null}, {"a": "odd", "b": null}, {"a": "x", "b": "y"}])


func test_fail_first(value: int = use_parameters([1, 2, 3])) -> void:
	assert_ne(value, 1)


func test_fail_last(value: int = use_parameters([1, 2, 3])) -> void:
	assert_ne(value, 3)


func test_pass_await(value: int = use_parameters([1, 2])) -> void:
	await wait_process_frames(1)
	assert_gt(value, 0)


func test_fail_await(value: int = use_parameters([1, 2])) -> void:
	await wait_process_frames(1)
	assert_gt(value, 1)


func test_fail_error_in_one(value: int = use_parameters([1, 2])) -> void:
	if value == 1:
		push_error("mishap in the first")
	assert_gt(value, 0)


func test_pending_one(value: int = use_parameters([1, 2])) -> void:
	if value == 1:
		pending("the first only")
	else:
		assert_eq(value, 2)


func test_fail_default_is_no_use_parameters(value: int = 3) -> void:
	assert_eq(value, 3)


func test_fail_no_default(value: int) -> void:
	assert_eq(value, 3)
