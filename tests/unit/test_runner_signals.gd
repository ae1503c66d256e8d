# SPDX-License-Identifier: MIT
extends GutTest
## Signals watched during a test.

signal told(what: String, times: int)


func before_each() -> void:
	watch_signals(self)


func test_counts_emissions() -> void:
	assert_signal_not_emitted(told)
	told.emit("a", 1)
	told.emit("b", 2)
	assert_signal_emit_count(told, 2)
	assert_signal_emitted_with_parameters(told, ["b", 2])
	assert_signal_emitted_with_parameters(told, ["a", 1], 0)


func test_forgets_emissions_of_other_tests() -> void:
	assert_signal_emit_count(told, 0)


func test_waits_for_a_signal() -> void:
	get_tree().create_timer(0.02).timeout.connect(_tell)
	assert_true(await wait_for_signal(told, 5.0))
	assert_signal_emitted_with_parameters(told, ["later", 3])


func test_gives_up_waiting() -> void:
	assert_false(await wait_for_signal(told, 0.05))


func _tell() -> void:
	told.emit("later", 3)
