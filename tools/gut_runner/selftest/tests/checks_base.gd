# SPDX-License-Identifier: MIT
extends GutTest
## Base of another test script; not one itself, by its name.


func test_pass_from_base() -> void:
	assert_true(true)


func test_pass_overridden() -> void:
	fail_test("the derived script has its own")
