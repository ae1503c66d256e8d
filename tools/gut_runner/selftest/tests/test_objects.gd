# SPDX-License-Identifier: MIT
extends GutTest
## Types and methods.


class Thing:
	extends Node

	func get_colour() -> String:
		return "red"


func test_pass_is() -> void:
	var node: Node2D = autofree(Node2D.new())
	assert_is(node, Node2D)
	assert_is(autofree(Thing.new()), Thing)
	assert_is(self, GutTest)


func test_fail_is() -> void:
	assert_is(autofree(Node.new()), Node2D)


func test_fail_is_value() -> void:
	assert_is([], Node)


func test_fail_is_text() -> void:
	assert_is("a", "b")


func test_fail_is_instance() -> void:
	assert_is(autofree(Node2D.new()), autofree(Node2D.new()))


func test_pass_typeof() -> void:
	assert_typeof(Color(1, 1, 1), TYPE_COLOR)
	assert_typeof(1, TYPE_INT)
	assert_not_typeof(1.0, TYPE_INT)


func test_fail_typeof() -> void:
	assert_typeof("text", TYPE_INT)


func test_fail_not_typeof() -> void:
	assert_not_typeof(1, TYPE_INT)


func test_pass_has_method() -> void:
	assert_has_method(autofree(Thing.new()), "get_colour")
	assert_has_method(autofree(Node.new()), "add_child")


func test_fail_has_method() -> void:
	assert_has_method(autofree(Node.new()), "no_such_method")


func test_pass_eq_object() -> void:
	var node: Node = autofree(Node.new())
	assert_eq(node, node)
	assert_ne(node, self)


func test_fail_eq_object() -> void:
	assert_eq(autofree(Node.new()), self)
