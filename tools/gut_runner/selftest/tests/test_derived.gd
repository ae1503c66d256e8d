# SPDX-License-Identifier: MIT
extends "res://tests/checks_base.gd"
## A test script may extend another one and inherits its tests.


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
