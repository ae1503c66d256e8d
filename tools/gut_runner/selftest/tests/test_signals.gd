# SPDX-License-Identifier: MIT
extends GutTest
## Watching signals: emitted or not.


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


func test_pass_emitted() -> void:
	_source.fired.emit(1, 2)
	assert_signal_emitted(_source, "fired")
	assert_signal_emitted(_source, "fired", "text")
	assert_signal_emitted(_source.fired)
	assert_signal_emitted(_source.fired, "text")
	assert_signal_not_emitted(_source, "quiet")
	assert_signal_not_emitted(_source.quiet)


func test_fail_emitted() -> void:
	assert_signal_emitted(_source, "quiet")


func test_fail_emitted_signal_form() -> void:
	assert_signal_emitted(_source.quiet)


func test_fail_emitted_not_watched() -> void:
	var other: Source = Source.new()
	other.quiet.emit()
	assert_signal_emitted(other, "quiet")


func test_fail_emitted_unknown() -> void:
	assert_signal_emitted(_source, "no_such_signal")


func test_fail_not_emitted() -> void:
	_source.quiet.emit()
	assert_signal_not_emitted(_source, "quiet")


func test_fail_not_emitted_signal_form() -> void:
	_source.quiet.emit()
	assert_signal_not_emitted(_source.quiet)


func test_fail_not_emitted_not_watched() -> void:
	assert_signal_not_emitted(Source.new(), "quiet")


func test_fail_not_emitted_unknown() -> void:
	assert_signal_not_emitted(_source, "no_such_signal")


func test_pass_has_signal() -> void:
	assert_has_signal(_source, "fired")


func test_fail_has_signal() -> void:
	assert_has_signal(_source, "no_such_signal")


func test_pass_watch_is_forgotten_after_a_test() -> void:
	assert_signal_emit_count(_source, "fired", 0)
	assert_signal_emit_count(_source, "quiet", 0)


func test_pass_watch_engine_node() -> void:
	var node: Node = autofree(Node.new())
	watch_signals(node)
	add_child(node)
	assert_signal_emitted(node, "tree_entered")
	assert_signal_emit_count(node, "ready", 1)
	remove_child(node)
	assert_signal_emitted(node.tree_exited)
