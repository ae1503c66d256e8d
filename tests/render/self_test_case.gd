# SPDX-License-Identifier: MIT
class_name SelfTestCase
extends GutTest
## What tests of the self-test share: the test itself, and which checks must find a fault.

var self_test: SelfTest


func before_each() -> void:
	self_test = SelfTest.new()
	add_child_autofree(self_test)


## Runs these checks; those and only those named must fail.
func expect(checks: Array[SelfCheck], faults: PackedStringArray) -> Array[CheckResult]:
	var results: Array[CheckResult] = await self_test.run(checks)
	assert_eq(failed(results), faults)
	for result in results:
		if not result.has_passed():
			gut.p("%s: %s %s %s" % [result.name, result.quantity, result.worst, result.objections])
	return results


func failed(results: Array[CheckResult]) -> PackedStringArray:
	var names: PackedStringArray = []
	for result in results:
		if not result.has_passed():
			names.append(result.name)
	return names
