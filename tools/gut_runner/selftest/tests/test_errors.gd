# SPDX-License-Identifier: MIT
extends GutTest
## Errors of the engine and push_error fail a test that does not deal with them.


func test_fail_push_error() -> void:
	push_error("a mishap")
	pass_test("the assert passes, the error does not")


func test_fail_engine_error() -> void:
	get_node("no_such_node")
	pass_test("the assert passes, the error does not")


func test_fail_script_error() -> void:
	var nothing: Variant = null
	nothing.call_me()
	pass_test("not reached")


func test_fail_script_error_after_await() -> void:
	await wait_process_frames(1)
	var nothing: Variant = null
	nothing.call_me()
	pass_test("not reached")


func test_pass_warning_is_not_an_error() -> void:
	push_warning("only a warning")
	pass_test("fine")


func test_fail_engine_warning() -> void:
	Image.load_from_file("res://pixel.png")
	pass_test("a warning of the engine itself counts as an error")


func test_fail_error_of_a_thread() -> void:
	var thread: Thread = Thread.new()
	thread.start(push_error.bind("from a thread"))
	thread.wait_to_finish()
	pass_test("the error is still counted")


func test_fail_error_after_last_assert() -> void:
	pass_test("first")
	await wait_process_frames(1)
	push_error("late")


class TestForgotten:
	extends GutTest

	func test_pass_errors_of_other_tests_are_forgotten() -> void:
		assert_eq(get_errors().size(), 0)
