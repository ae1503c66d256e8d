# SPDX-License-Identifier: MIT
extends RefCounted
## What came out of a run: scripts, their tests, totals.


## One test, or one failing before_all / after_all.
class TestResult:
	extends RefCounted

	var name: String = ""
	var passes: int = 0
	var fails: PackedStringArray = []
	var pendings: PackedStringArray = []
	var seconds: float = 0.0

	func _init(test_name: String) -> void:
		name = test_name

	## "fail", "pending", "pass" or "no asserts" (risky), in this order of weight.
	func status() -> String:
		if not fails.is_empty():
			return "fail"
		if not pendings.is_empty():
			return "pending"
		return "pass" if passes > 0 else "no asserts"

	func asserts() -> int:
		return passes + fails.size()


## One test script or inner class.
class ScriptResult:
	extends RefCounted

	## "tests/unit/test_x.gd" or "tests/unit/test_x.gd.TestInner".
	var name: String = ""
	var tests: Array[TestResult] = []
	## Why the whole script was skipped; empty when it ran.
	var skip_reason: String = ""

	func _init(script_name: String) -> void:
		name = script_name

	func count(status: String) -> int:
		var found: int = 0
		for test: TestResult in tests:
			found += int(test.status() == status)
		return found

	func seconds() -> float:
		var sum: float = 0.0
		for test: TestResult in tests:
			sum += test.seconds
		return sum


var scripts: Array[ScriptResult] = []
## Complaints that fail the run whatever the tests did: scripts that do not load, directories not
## there.
var complaints: PackedStringArray = []


func get_scripts() -> Array[ScriptResult]:
	return scripts


## Counts: scripts, tests, passing, failing, pending, risky, asserts, skipped (scripts).
func get_totals() -> Dictionary:
	var totals: Dictionary = {
		"scripts": scripts.size(),
		"tests": 0,
		"passing": 0,
		"failing": 0,
		"pending": 0,
		"risky": 0,
		"asserts": 0,
		"skipped": 0,
	}
	for script: ScriptResult in scripts:
		totals.tests += script.tests.size()
		totals.passing += script.count("pass")
		totals.failing += script.count("fail")
		totals.pending += script.count("pending")
		totals.risky += script.count("no asserts")
		totals.skipped += int(not script.skip_reason.is_empty())
		for test: TestResult in script.tests:
			totals.asserts += test.asserts()
	return totals


## 0 when at least one test ran, none failed and there is no complaint; otherwise 1.
func exit_code() -> int:
	var totals: Dictionary = get_totals()
	var proved: bool = totals.tests > 0 and totals.failing == 0 and complaints.is_empty()
	return 0 if proved else 1
