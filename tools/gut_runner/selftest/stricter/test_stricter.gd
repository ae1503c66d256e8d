# SPDX-License-Identifier: MIT
extends GutTest
## What this runner fails and GUT 9.6 lets pass (or hangs on): never the other way round.


func test_fail_beats_pending() -> void:
	pending("the rest")
	assert_true(false)


func test_fail_between_nan() -> void:
	assert_between(NAN, 0.0, 1.0)


func test_fail_not_between_nan() -> void:
	assert_not_between(NAN, 0.0, 1.0)


func test_fail_almost_ne_nan() -> void:
	assert_almost_ne(NAN, 1.0, 0.1)


func test_fail_almost_ne_vector_with_nan() -> void:
	assert_almost_ne(Vector3(9, 9, NAN), Vector3(1, 1, 1), Vector3(0.1, 0.1, 0.1))


func test_fail_no_parameters(value: int = use_parameters([])) -> void:
	assert_eq(value, 0)


class TestErrorBefore:
	extends GutTest

	func before_each() -> void:
		push_error("in before_each")

	func test_fail_error_before() -> void:
		pass_test("fine in itself")


class TestErrorAfter:
	extends GutTest

	func after_each() -> void:
		push_error("in after_each")

	func test_fail_error_after() -> void:
		pass_test("fine in itself")


class TestErrorOutside:
	extends GutTest

	func before_all() -> void:
		push_error("in before_all")

	func after_all() -> void:
		assert_true(false)

	func test_pass_in_between() -> void:
		pass_test("the script fails, not the test")
