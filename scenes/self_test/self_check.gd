# SPDX-License-Identifier: MIT
class_name SelfCheck
extends RefCounted
## One question put to the graphics card whose answer core knows. What it draws is in its members,
## so that a test can damage it.

const FIRST_THINGS_FIRST: String = "If another check above has failed too, that fault comes first. "

## As the report lists it.
var name: StringName
var compares: String = ""
var fault: String = ""
var remedy: String = ""


## Draws, reads back and compares; to be overridden.
func measure(stage: SelfTestStage, result: CheckResult) -> void:
	await stage.get_tree().process_frame
	result.object("Nothing is measured.")


## What helps against most faults of a driver.
static func newer_driver_or_renderer() -> String:
	var others: PackedStringArray = []
	for renderer: String in ["mobile", "forward_plus", "gl_compatibility"]:
		if renderer != RenderingServer.get_current_rendering_method():
			others.append(renderer)
	return (
		"Update the graphics driver. If it is the newest, start with another renderer"
		+ " (--rendering-method %s)." % " or ".join(others)
	)


## An empty result with this check's words.
func blank_result() -> CheckResult:
	var empty := CheckResult.new()
	empty.name = name
	empty.compares = compares
	empty.fault = fault
	empty.remedy = remedy
	return empty
