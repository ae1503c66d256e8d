# SPDX-License-Identifier: MIT
extends GutTest
## Freed objects, orphans, freeing after a test.


func test_pass_freed() -> void:
	var node: Node = Node.new()
	assert_not_freed(node, "node")
	node.free()
	assert_freed(node, "node")


func test_fail_freed() -> void:
	assert_freed(autofree(Node.new()), "node")


func test_fail_not_freed() -> void:
	var node: Node = Node.new()
	node.free()
	assert_not_freed(node, "node")


func test_pass_no_new_orphans() -> void:
	var node: Node = Node.new()
	node.free()
	assert_no_new_orphans()


func test_fail_no_new_orphans() -> void:
	autofree(Node.new())
	assert_no_new_orphans()


func test_pass_add_child_autofree() -> void:
	var node: Node = add_child_autofree(Node.new())
	assert_same(node.get_parent(), self)
	assert_true(node.is_inside_tree())
	var other: Node = add_child_autoqfree(Node.new())
	assert_true(other.is_inside_tree())


class TestFreeing:
	extends GutTest

	static var _freed: Node = null
	static var _queued: Node = null

	func test_pass_1_make() -> void:
		_freed = autofree(Node.new())
		_queued = autoqfree(Node.new())
		assert_not_freed(_freed, "autofree")

	func test_pass_2_gone() -> void:
		await wait_process_frames(2)
		assert_freed(_freed, "autofree")
		assert_freed(_queued, "autoqfree")
