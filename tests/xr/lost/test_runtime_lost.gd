# SPDX-License-Identifier: MIT
extends XrTestCase
## A runtime that dies is noticed. There is no other for the same process afterwards: this script
## has one of its own.


func test_a_runtime_that_dies_is_noticed() -> void:
	if not await begun():
		return
	var session := visit.scene.session
	watch_signals(session)
	await wait_seconds(1.0)
	assert_eq(session.state, XrSession.State.FOCUSED)
	assert_eq(_control("kill"), 0)
	var killed := Time.get_ticks_msec()
	assert_true(await visit.settle(func() -> bool: return session.state == XrSession.State.LOST))
	gut.p("noticed after %.1f s" % ((Time.get_ticks_msec() - killed) * 0.001))
	assert_lt(Time.get_ticks_msec() - killed, 2000, "within two seconds")
	assert_false(visit.scene.session.viewport.use_xr)
	assert_signal_emit_count(session, "lost", 1)
	assert_signal_emit_count(session, "focus_changed", 1)
	assert_true(visit.scene.is_waiting_for_headset(), "the screen says so")
	for error: GutTrackedError in get_errors():
		error.handled = true  # the runtime's and the engine's own, about the runtime's death


func _control(word: String) -> int:
	return OS.execute(OS.get_environment("BLACKHOLE_HEADSET_CONTROL"), [word])
