# SPDX-License-Identifier: MIT
extends GutTest
## Pending, risky, explicit outcomes, state of a test.


func test_pending_plain() -> void:
	pending()


func test_pending_text() -> void:
	pending("not yet written")


func test_pending_after_pass() -> void:
	assert_true(true)
	pending("the rest")


func test_risky_no_assert() -> void:
	pass


func test_pass_pass_test() -> void:
	pass_test("done")


func test_fail_fail_test() -> void:
	fail_test("no")


func test_fail_stays_failed() -> void:
	assert_true(false)
	pass_test("does not undo it")


func test_pass_state() -> void:
	assert_true(true)
	assert_true(is_passing())
	assert_false(is_failing())


func test_fail_state() -> void:
	assert_true(false)
	if is_passing() or not is_failing():
		pending("is_failing() was wrong")


func test_pass_version() -> void:
	assert_false(skip_if_godot_version_lt("4.6.0"))


func test_pass_version_later() -> void:
	if skip_if_godot_version_lt("99.0.0"):
		return
	fail_test("not reached")


func test_pass_simulate() -> void:
	var counter: Counter = autofree(Counter.new())
	simulate(counter, 5, 0.1)
	assert_eq(counter.frames, 5)
	assert_almost_eq(counter.time, 0.5, 1e-9)


func test_pass_printing() -> void:
	gut.p("a line from a test")
	pass_test("printed")


func not_a_test() -> void:
	fail_test("must never run")


class Counter:
	extends Node

	var frames: int = 0
	var time: float = 0.0

	func _process(delta: float) -> void:
		frames += 1
		time += delta


class Helper:
	extends GutTest

	func test_fail_is_never_run() -> void:
		pass_test("its class is not called Test...")
