# SPDX-License-Identifier: MIT
class_name SelfTestReport
extends RefCounted
## What a self-test found, as a table for people and as JSON for programs.


## The card, its driver and the renderer.
static func device() -> Dictionary:
	return {
		"device": RenderingServer.get_video_adapter_name(),
		"vendor": RenderingServer.get_video_adapter_vendor(),
		"api": RenderingServer.get_video_adapter_api_version(),
		"driver": " ".join(OS.get_video_adapter_driver_info()),
		"renderer": RenderingServer.get_current_rendering_method(),
		"system": "%s %s" % [OS.get_name(), OS.get_version()],
		"godot": Engine.get_version_info()["string"],
		"addon": ProgramVersion.text(),
	}


## Does the processor draw, rather than a graphics card?
static func is_software() -> bool:
	if RenderingServer.get_video_adapter_type() == RenderingDevice.DEVICE_TYPE_CPU:
		return true
	var name := RenderingServer.get_video_adapter_name().to_lower()
	for software: String in ["llvmpipe", "softpipe", "swiftshader", "basic render"]:
		if name.contains(software):
			return true
	return false


## The lines to print.
static func lines(results: Array[CheckResult]) -> PackedStringArray:
	var text: PackedStringArray = []
	var about := device()
	for key: String in about:
		if not str(about[key]).is_empty():
			text.append("%-10s%s" % [key, about[key]])
	if is_software():
		text.append("The processor draws this: a graphics card, if there is one, is not used.")
		text.append("Installing its driver (Vulkan, or OpenGL for gl_compatibility) helps.")
	text.append("")
	text.append("%-17s%-42s%-14s%-14s%s" % ["check", "worst measurement", "error", "limit", ""])
	for result in results:
		text.append(_row(result))
	for result in results:
		if not result.has_passed():
			text.append_array(_explanation(result))
	var word := "PASS" if SelfTest.have_passed(results) else "FAIL"
	text.append_array(["", "%s: %s" % [word, verdict(results)]])
	return text


## One sentence that says it all.
static func verdict(results: Array[CheckResult]) -> String:
	var failed: PackedStringArray = []
	for result in results:
		if not result.has_passed():
			failed.append(result.name)
	if failed.is_empty():
		return (
			"This GPU draws the sky right: %d of %d checks passed."
			% [results.size(), results.size()]
		)
	return (
		"This GPU does NOT draw the sky right: %d of %d checks failed (%s). Look at %s first."
		% [failed.size(), results.size(), ", ".join(failed), failed[0]]
	)


## All of it as JSON.
static func json(results: Array[CheckResult]) -> String:
	var found := device()
	found["software"] = is_software()
	found["passed"] = SelfTest.have_passed(results)
	found["verdict"] = verdict(results)
	var list: Array[Dictionary] = []
	for result in results:
		list.append(result.to_dictionary())
	found["checks"] = list
	found["report"] = Array(lines(results))
	return JSON.stringify(found, "\t", false) + "\n"


static func _row(result: CheckResult) -> String:
	var error := _number(result.worst, result.unit)
	var limit := _number(result.limit, result.unit)
	var word := "ok" if result.has_passed() else "FAULT"
	return "%-17s%-42s%-14s%-14s%s" % [result.name, result.quantity, error, limit, word]


static func _explanation(result: CheckResult) -> PackedStringArray:
	var text: PackedStringArray = ["", "FAULT %s: %s" % [result.name, result.fault]]
	text.append("  compared: %s" % result.compares)
	for sentence in result.objections:
		text.append("  %s" % sentence)
	text.append("  remedy: %s" % result.remedy)
	return text


static func _number(value: float, unit: String) -> String:
	if not is_finite(value):
		return "no number"
	var text := "%.4f" % value
	if value == roundf(value):
		text = "%d" % value
	elif absf(value) < 0.001:
		text = _scientific(value)
	return text if unit.is_empty() else "%s %s" % [text, unit]


## Like 1.2e-07.
static func _scientific(value: float) -> String:
	var exponent := floori(log(absf(value)) / log(10.0))
	return "%.1fe%d" % [value / pow(10.0, exponent), exponent]
