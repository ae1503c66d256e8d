# SPDX-License-Identifier: MIT
extends GutTest
## Accessors, exports, properties.


class Thing:
	extends Node

	@export var shown: int = 3
	var hidden: int = 4
	var plain: float = 1.0
	var size: float = 1.0:
		set(value):
			size = value
		get:
			return size
	var stuck: float = 1.0:
		set(_value):
			pass
		get:
			return stuck
	var _colour: String = "red"

	func get_colour() -> String:
		return _colour

	func set_colour(value: String) -> void:
		_colour = value

	func get_fixed() -> int:
		return 1

	func set_fixed(_value: int) -> void:
		pass


func test_pass_accessors() -> void:
	assert_accessors(autofree(Thing.new()), "colour", "red", "blue")


func test_fail_accessors_default() -> void:
	assert_accessors(autofree(Thing.new()), "colour", "green", "blue")


func test_fail_accessors_do_not_store() -> void:
	assert_accessors(autofree(Thing.new()), "fixed", 1, 2)


func test_fail_accessors_missing() -> void:
	assert_accessors(autofree(Thing.new()), "absent", 1, 2)


func test_pass_exports() -> void:
	assert_exports(autofree(Thing.new()), "shown", TYPE_INT)


func test_fail_exports_type() -> void:
	assert_exports(autofree(Thing.new()), "shown", TYPE_VECTOR2)


func test_fail_exports_not_exported() -> void:
	assert_exports(autofree(Thing.new()), "hidden", TYPE_INT)


func test_fail_exports_absent() -> void:
	assert_exports(autofree(Thing.new()), "absent", TYPE_INT)


func test_pass_property() -> void:
	assert_property(autofree(Thing.new()), "size", 1.0, 2.0)


func test_fail_property_default() -> void:
	assert_property(autofree(Thing.new()), "size", 3.0, 2.0)


func test_fail_property_without_accessors() -> void:
	assert_property(autofree(Thing.new()), "plain", 1.0, 2.0)


func test_fail_property_stuck() -> void:
	assert_property(autofree(Thing.new()), "stuck", 1.0, 2.0)
