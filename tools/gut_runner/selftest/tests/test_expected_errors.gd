# SPDX-License-Identifier: MIT
extends GutTest
## Dealing with errors.


func test_pass_assert_push_error() -> void:
	push_error("The Mishap of today")
	assert_push_error("mishap")


func test_fail_assert_push_error_absent() -> void:
	assert_push_error("mishap")


func test_fail_assert_push_error_other_text() -> void:
	push_error("something else")
	assert_push_error("mishap")


func test_fail_one_error_is_counted_once() -> void:
	push_error("mishap")
	assert_push_error("mishap")
	assert_push_error("mishap")


func test_fail_second_error_stays() -> void:
	push_error("mishap one")
	push_error("mishap two")
	assert_push_error("mishap one")


func test_pass_two_errors() -> void:
	push_error("mishap one")
	push_error("mishap two")
	assert_push_error("mishap two")
	assert_push_error("mishap one")


func test_pass_push_error_count() -> void:
	push_error("mishap one")
	push_error("mishap two")
	assert_push_error_count(2)


func test_fail_push_error_count() -> void:
	push_error("mishap one")
	assert_push_error_count(2)


func test_pass_no_errors_counted() -> void:
	assert_push_error_count(0)
	assert_engine_error_count(0)
	assert_push_warning_count(0)


func test_pass_assert_engine_error() -> void:
	get_node("no_such_node")
	assert_engine_error("NODE NOT FOUND")


func test_pass_engine_error_count() -> void:
	get_node("no_such_node")
	get_node("nor_this")
	assert_engine_error_count(2, "text")


func test_fail_engine_error_is_not_push_error() -> void:
	get_node("no_such_node")
	assert_push_error("node")


func test_fail_push_error_is_not_engine_error() -> void:
	push_error("mishap")
	assert_engine_error("mishap")


func test_pass_script_error_is_engine_error() -> void:
	_stumble()
	assert_engine_error("call_me")


func test_pass_get_errors() -> void:
	push_error("mishap")
	get_node("no_such_node")
	push_warning("a warning")
	var pushed: int = 0
	var engine: int = 0
	for error: GutTrackedError in get_errors():
		pushed += int(error.is_push_error())
		engine += int(error.is_engine_error())
		error.handled = true
	assert_eq(pushed, 1)
	assert_eq(engine, 1)


func test_pass_contains_text() -> void:
	push_error("A Mishap")
	var error: GutTrackedError = get_errors()[0]
	assert_true(error.contains_text("a mishap"))
	assert_false(error.contains_text("else"))
	assert_push_error("mishap")


func test_pass_push_warning() -> void:
	push_warning("mind the step")
	assert_push_warning("mind")


func test_pass_push_warning_count() -> void:
	push_warning("mind the step")
	assert_push_warning_count(1)


func test_fail_push_warning_absent() -> void:
	assert_push_warning("mind")


func _stumble() -> void:
	var nothing: Variant = null
	nothing.call_me()
