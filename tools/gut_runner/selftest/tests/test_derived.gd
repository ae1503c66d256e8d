# SPDX-License-Identifier: MIT
extends "res://tests/checks_base.gd"
## A test script may extend another one and inherits its tests.

# Named like inner test classes, but not one.
const TEST_NUMBER: int = 3
const TEST_LIST: Array[int] = [1, 2]
# gdlint:ignore=constant-name
const TestNumbers: Dictionary[String, int] = {"one": 1}


func test_pass_overridden() -> void:
	pass_test("the one of the derived script")


class TestFirst:
	extends GutTest

	func test_pass_first() -> void:
		pass_test("first")


class TestSecond:
	extends TestFirst

	func test_pass_second() -> void:
		pass_test("second")
