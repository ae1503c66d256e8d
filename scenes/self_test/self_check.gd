# SPDX-License-Identifier: MIT
class_name SelfCheck
extends RefCounted
## One question put to the graphics card whose answer core knows. What it draws is in its members,
## so that a test can damage it.

## As the report lists it.
var name: StringName
var compares: String = ""
var fault: String = ""
var remedy: String = ""


## Draws, reads back and compares; to be overridden.
func measure(stage: SelfTestStage, result: CheckResult) -> void:
	await stage.get_tree().process_frame
	result.object("Nothing is measured.")


## An empty result with this check's words.
func blank_result() -> CheckResult:
	var empty := CheckResult.new()
	empty.name = name
	empty.compares = compares
	empty.fault = fault
	empty.remedy = remedy
	return empty
