# SPDX-License-Identifier: MIT
extends GutTest
## Order of the calls round tests; inner classes come after the outer tests.

static var calls: PackedStringArray = []


func before_all() -> void:
	await wait_process_frames(1)
	calls.append("before_all")


func before_each() -> void:
	await wait_process_frames(1)
	calls.append("before_each")


func after_each() -> void:
	await wait_process_frames(1)
	calls.append("after_each")


func after_all() -> void:
	await wait_process_frames(1)
	calls.append("after_all")


func test_pass_one() -> void:
	calls.append("one")
	assert_true(is_inside_tree())


func test_fail_two() -> void:
	calls.append("two")
	fail_test("on purpose: after_each must follow all the same")


class TestOrder:
	extends GutTest

	const Outer := preload("res://tests/test_lifecycle.gd")

	func test_pass_order() -> void:
		var expected: String = "before_all before_each one after_each before_each two after_each"
		assert_eq(" ".join(Outer.calls), expected + " after_all")

	func test_fail_inner() -> void:
		fail_test("on purpose")


class TestOwnLifecycle:
	extends GutTest

	var _ready_for_test: bool = false

	func before_all() -> void:
		_ready_for_test = true

	func test_pass_own_before_all() -> void:
		assert_true(_ready_for_test)


class TestAssertsRoundTheTest:
	extends GutTest

	func before_each() -> void:
		assert_true(true)

	func test_pass_assert_in_before_each_counts() -> void:
		pass


class TestFailsBefore:
	extends GutTest

	func before_each() -> void:
		assert_true(false)

	func test_fail_in_before_each() -> void:
		pass_test("fine in itself")


class TestFailsAfter:
	extends GutTest

	func after_each() -> void:
		assert_true(false)

	func test_fail_in_after_each() -> void:
		pass_test("fine in itself")
