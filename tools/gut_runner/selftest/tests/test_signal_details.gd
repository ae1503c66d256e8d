# SPDX-License-Identifier: MIT
extends GutTest
## How often signals were emitted and with what.


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


func test_pass_count() -> void:
	_source.fired.emit(1, 2)
	_source.fired.emit(3, 4)
	assert_signal_emit_count(_source, "fired", 2)
	assert_signal_emit_count(_source.fired, 2, "text")
	assert_signal_emit_count(_source, "quiet", 0)
	assert_eq(get_signal_emit_count(_source, "fired"), 2)
	assert_eq(get_signal_emit_count(_source.fired), 2)
	assert_eq(get_signal_emit_count(_source, "quiet"), 0)
	assert_eq(get_signal_emit_count(_source, "no_such_signal"), -1)


func test_fail_count() -> void:
	_source.quiet.emit()
	assert_signal_emit_count(_source, "quiet", 2)


func test_fail_count_signal_form() -> void:
	assert_signal_emit_count(_source.quiet, 1)


func test_fail_count_not_watched() -> void:
	assert_signal_emit_count(Source.new(), "quiet", 0)


func test_pass_parameters() -> void:
	_source.fired.emit(1, "a")
	_source.fired.emit(2, "b")
	assert_signal_emitted_with_parameters(_source, "fired", [2, "b"])
	assert_signal_emitted_with_parameters(_source.fired, [2, "b"])
	assert_signal_emitted_with_parameters(_source, "fired", [1, "a"], 0)
	assert_signal_emitted_with_parameters(_source.fired, [1, "a"], 0)
	assert_eq(get_signal_parameters(_source, "fired"), [2, "b"])
	assert_eq(get_signal_parameters(_source, "fired", 0), [1, "a"])
	assert_eq(get_signal_parameters(_source.fired, 0), [1, "a"])
	assert_null(get_signal_parameters(_source, "quiet"))


func test_fail_parameters_last_is_meant() -> void:
	_source.fired.emit(1, "a")
	_source.fired.emit(2, "b")
	assert_signal_emitted_with_parameters(_source, "fired", [1, "a"])


func test_fail_parameters_index() -> void:
	_source.fired.emit(1, "a")
	_source.fired.emit(2, "b")
	assert_signal_emitted_with_parameters(_source, "fired", [2, "b"], 0)


func test_fail_parameters_never_emitted() -> void:
	assert_signal_emitted_with_parameters(_source, "fired", [1, "a"])


func test_fail_parameters_index_too_high() -> void:
	_source.fired.emit(1, "a")
	assert_signal_emitted_with_parameters(_source, "fired", [1, "a"], 3)
