# SPDX-License-Identifier: MIT
extends GutTest
## Waiting: seconds, frames, signals, conditions.

signal rung(number: int)

var _ready_after: int = 0


func test_pass_seconds() -> void:
	# Two frames first: a slow frame before this test must not count.
	await wait_process_frames(2)
	var start: int = Time.get_ticks_msec()
	await wait_seconds(0.2)
	assert_between(Time.get_ticks_msec() - start, 100, 10000)


func test_pass_process_frames() -> void:
	var start: int = Engine.get_process_frames()
	await wait_process_frames(5)
	assert_between(Engine.get_process_frames() - start, 4, 6)


func test_pass_idle_frames() -> void:
	var start: int = Engine.get_process_frames()
	await wait_idle_frames(5, "text")
	assert_between(Engine.get_process_frames() - start, 4, 6)


func test_pass_physics_frames() -> void:
	var start: int = Engine.get_physics_frames()
	await wait_physics_frames(5)
	assert_between(Engine.get_physics_frames() - start, 4, 6)


func test_pass_signal() -> void:
	_ring_later()
	var came: bool = await wait_for_signal(rung, 2.0)
	assert_true(came)
	assert_false(did_wait_timeout())
	assert_signal_emitted_with_parameters(self, "rung", [7])


func test_pass_signal_times_out() -> void:
	var came: bool = await wait_for_signal(rung, 0.1)
	assert_false(came)
	assert_true(did_wait_timeout())


func test_fail_assert_after_timeout() -> void:
	assert_true(await wait_for_signal(rung, 0.1))


func test_pass_until() -> void:
	_ready_after = Time.get_ticks_msec() + 100
	assert_true(await wait_until(_is_ready, 2.0))
	assert_false(did_wait_timeout())


func test_pass_until_between() -> void:
	_ready_after = Time.get_ticks_msec() + 100
	assert_true(await wait_until(_is_ready, 2.0, 0.05, "text"))


func test_pass_until_times_out() -> void:
	assert_false(await wait_until(func() -> bool: return false, 0.1, "text"))
	assert_true(did_wait_timeout())


func test_pass_until_wants_exactly_true() -> void:
	assert_false(await wait_until(func() -> int: return 1, 0.1))


func test_pass_while() -> void:
	_ready_after = Time.get_ticks_msec() + 100
	assert_true(await wait_while(func() -> bool: return not _is_ready(), 2.0))


func test_pass_while_times_out() -> void:
	assert_false(await wait_while(func() -> bool: return true, 0.1))
	assert_true(did_wait_timeout())


func test_pass_bare_await() -> void:
	await get_tree().process_frame
	await get_tree().create_timer(0.05).timeout
	pass_test("came back")


func test_fail_after_await() -> void:
	await wait_process_frames(2)
	assert_eq(1, 2)


func _is_ready() -> bool:
	return Time.get_ticks_msec() >= _ready_after


func _ring_later() -> void:
	await get_tree().create_timer(0.05).timeout
	rung.emit(7)
