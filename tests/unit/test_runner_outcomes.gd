# SPDX-License-Identifier: MIT
extends GutTest
## What every other test relies on: calls in order, waiting, freeing, errors noticed.

var _calls: PackedStringArray = []


func before_all() -> void:
	_calls.append("before_all")


func before_each() -> void:
	_calls.append("before_each")


func after_each() -> void:
	_calls.append("after_each")


func test_calls_come_in_order() -> void:
	# Whatever test ran before this one: every test is embraced, and before_all came once.
	assert_eq(_calls[0], "before_all")
	assert_eq(_calls.count("before_all"), 1)
	assert_eq(_calls[-1], "before_each")
	assert_eq(_calls.count("before_each"), _calls.count("after_each") + 1)


func test_is_in_the_tree_and_can_wait() -> void:
	assert_true(is_inside_tree())
	var frame: int = Engine.get_process_frames()
	await wait_process_frames(3)
	assert_gte(Engine.get_process_frames() - frame, 3)


func test_waits_for_a_condition_at_most_so_long() -> void:
	var frame: int = Engine.get_process_frames() + 3
	assert_true(await wait_until(func() -> bool: return Engine.get_process_frames() > frame, 5.0))
	assert_false(await wait_until(func() -> bool: return false, 0.05))


func test_sees_errors() -> void:
	push_error("an error on purpose")
	assert_eq(get_errors().size(), 1)
	assert_push_error("on purpose")


func test_sees_errors_of_the_engine() -> void:
	get_node("no_such_node")
	assert_engine_error("not found")


func test_called_for_each_parameter(value: int = use_parameters([2, 3, 5])) -> void:
	assert_has([2, 3, 5], value)


class TestFreeing:
	extends GutTest

	var _node: Node = null

	func test_1_adds_a_child() -> void:
		_node = add_child_autofree(Node.new())
		assert_same(_node.get_parent(), self)

	func test_2_child_is_gone() -> void:
		assert_freed(_node, "the child of the test before")
