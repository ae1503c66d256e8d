# SPDX-License-Identifier: MIT
extends GutTest
## A script that says it must be skipped. The override has no return type: GUT's own has none.


func should_skip_script():
	return "not on this machine"


func test_fail_never_run() -> void:
	pass_test("must not run")


class TestSkipped:
	extends GutTest

	func should_skip_script():
		return true

	func test_fail_never_run() -> void:
		pass_test("must not run")


class TestNotSkipped:
	extends GutTest

	func should_skip_script():
		return false

	func test_pass_runs() -> void:
		pass_test("an inner class decides for itself")
