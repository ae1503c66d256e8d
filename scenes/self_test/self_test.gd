# SPDX-License-Identifier: MIT
class_name SelfTest
extends Node
## Is this graphics card right? Puts questions to it whose answers core knows.
##
##     var results := await SelfTest.run_in(self)

## A check has ended.
signal progressed(done: int, total: int, result: CheckResult)

const TABLE_FILE: String = "res://addons/blackhole_sky/data/schwarzschild.lut"

## Where the checks draw; its table and sky may be changed before run().
var stage := SelfTestStage.new()

var _listener := ErrorListener.new()


func _init() -> void:
	add_child(stage)
	var table := LensingTable.new()
	if FileAccess.file_exists(TABLE_FILE) and table.load_file(TABLE_FILE) == OK:
		stage.use_table(table)


func _enter_tree() -> void:
	OS.add_logger(_listener)


func _exit_tree() -> void:
	OS.remove_logger(_listener)


## All checks, those first whose faults are the cause of others.
static func all_checks() -> Array[SelfCheck]:
	return [
		ShadersCheck.new(),
		FloatTexturesCheck.new(),
		InstanceFloatsCheck.new(),
		StarLookupsCheck.new(),
		RayLookupsCheck.new(),
		PlanckLookupsCheck.new(),
		StarPlacesCheck.new(),
		FaintLightCheck.new(),
		BackgroundCheck.new(),
	]


## Runs checks one after the other, with a node of its own below `parent`.
static func run_in(parent: Node) -> Array[CheckResult]:
	var test := SelfTest.new()
	parent.add_child(test)
	var results: Array[CheckResult] = await test.run()
	test.queue_free()
	return results


## Runs checks one after the other, which takes some seconds and draws nothing in the window. The
## node must be in the tree.
func run(checks: Array[SelfCheck] = all_checks()) -> Array[CheckResult]:
	if stage.tables == null:
		var table := LensingTable.new()
		table.bake()
		await table.bake_finished
		stage.use_table(table)
	var results: Array[CheckResult] = []
	for check in checks:
		_listener.take()
		var result := check.blank_result()
		await check.measure(stage, result)
		for words in _listener.take():
			result.object("The engine says: %s" % words)
		results.append(result)
		progressed.emit(results.size(), checks.size(), result)
	return results


## Have all checks passed?
static func have_passed(results: Array[CheckResult]) -> bool:
	for result in results:
		if not result.has_passed():
			return false
	return not results.is_empty()
