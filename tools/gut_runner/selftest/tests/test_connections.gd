# SPDX-License-Identifier: MIT
extends GutTest
## Connections of signals.


class Source:
	extends RefCounted

	signal fired(a: Variant, b: Variant)
	signal quiet
	signal slotted

	func on_slotted() -> void:
		pass

	func other() -> void:
		pass


var _source: Source


func before_each() -> void:
	_source = Source.new()
	watch_signals(_source)


func test_pass_connected() -> void:
	_source.slotted.connect(_source.on_slotted)
	assert_connected(_source, _source, "slotted")
	assert_connected(_source, _source, "slotted", "on_slotted")
	assert_connected(_source.slotted, _source.on_slotted)
	assert_connected(_source.slotted, _source)
	assert_not_connected(_source, _source, "slotted", "other")
	assert_not_connected(_source.slotted, _source.other)
	assert_not_connected(_source, self, "quiet")


func test_fail_connected() -> void:
	assert_connected(_source, _source, "slotted")


func test_fail_connected_method() -> void:
	_source.slotted.connect(_source.on_slotted)
	assert_connected(_source, _source, "slotted", "other")


func test_fail_connected_callable() -> void:
	_source.slotted.connect(_source.on_slotted)
	assert_connected(_source.slotted, _source.other)


func test_fail_not_connected() -> void:
	_source.slotted.connect(_source.on_slotted)
	assert_not_connected(_source, _source, "slotted", "on_slotted")


func test_fail_not_connected_object() -> void:
	_source.slotted.connect(_source.on_slotted)
	assert_not_connected(_source.slotted, _source)
