# SPDX-License-Identifier: MIT
extends SelfTestCase
## The self-test passes where the card is right. In each run ./run self-test is tried as well.

@warning_ignore("untyped_declaration")
func should_skip_script():
	return RendererScope.with_everything_alone()


func test_this_machine_passes() -> void:
	watch_signals(self_test)
	var results: Array[CheckResult] = await self_test.run()
	for line in SelfTestReport.lines(results):
		gut.p(line)
	assert_eq(failed(results), PackedStringArray())
	assert_true(SelfTest.have_passed(results))
	assert_signal_emit_count(self_test, "progressed", results.size())
	assert_gte(results.size(), 9)
