# SPDX-License-Identifier: MIT
extends RefCounted
## What a run prints: a line per script, what failed in it, a summary.

const Results := preload("results.gd")
const RED := "31"
const GREEN := "32"
const YELLOW := "33"

var log_level: int = 1
var colours: bool = true


func _init(level: int, with_colours: bool) -> void:
	log_level = level
	colours = with_colours and not OS.has_environment("NO_COLOR")


## Before a script: names it, so that the errors the engine prints can be told apart.
func script_begins(name: String, number: int, of_all: int) -> void:
	print("[%d/%d] %s" % [number, of_all, name])


func test_begins(name: String) -> void:
	if log_level >= 2:
		print("  %s" % name)


func waiting(message: String) -> void:
	if log_level >= 3:
		print("    %s" % message)


func test_ended(test: Results.TestResult) -> void:
	var status: String = test.status()
	if status == "fail":
		print(_paint("  FAILED   %s" % test.name, RED))
		_print_indented(test.fails)
	elif status == "pending" and log_level >= 1:
		print(_paint("  pending  %s" % test.name, YELLOW))
		_print_indented(test.pendings)
	elif status == "no asserts" and log_level >= 1:
		print(_paint("  risky    %s: it asserts nothing" % test.name, YELLOW))


func script_ended(script: Results.ScriptResult) -> void:
	if not script.skip_reason.is_empty():
		print(_paint("  skipped: %s" % script.skip_reason, YELLOW))
		return
	var failing: int = script.count("fail")
	var line: String = "  %d of %d passed" % [script.count("pass"), script.tests.size()]
	line += ", %d failed" % failing if failing > 0 else ""
	print(_paint("%s (%.2f s)" % [line, script.seconds()], RED if failing > 0 else GREEN))


func complain(text: String) -> void:
	printerr(_paint("ERROR: %s" % text, RED))


func summary(results: Results) -> void:
	print("")
	for script: Results.ScriptResult in results.scripts:
		for test: Results.TestResult in script.tests:
			if test.status() == "fail":
				print(_paint("FAILED %s :: %s" % [script.name, test.name], RED))
	for complaint: String in results.complaints:
		complain(complaint)
	var totals: Dictionary = results.get_totals()
	if totals.tests == 0:
		complain("no test was run")
	var counts: String = "{scripts} scripts ({skipped} skipped), {tests} tests: {passing} passed, "
	counts += "{failing} failed, {pending} pending, {risky} risky; {asserts} asserts"
	print(_paint(counts.format(totals), GREEN if results.exit_code() == 0 else RED))


func _print_indented(texts: PackedStringArray) -> void:
	for text: String in texts:
		print("           " + text.replace("\n", "\n           "))


func _paint(text: String, colour: String) -> String:
	return "\u001b[%sm%s\u001b[0m" % [colour, text] if colours else text
