# SPDX-License-Identifier: MIT
extends GutTest
## An error that no test can be blamed for fails the run.


func _init() -> void:
	push_error("outside all tests")


func test_pass_for_itself() -> void:
	pass_test("fine")
