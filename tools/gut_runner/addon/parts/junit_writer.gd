# SPDX-License-Identifier: MIT
extends RefCounted
## Writes the results of a run as JUnit XML.

const Results := preload("results.gd")


## The XML text of a run.
static func to_xml(results: Results) -> String:
	var totals: Dictionary = results.get_totals()
	var lines: PackedStringArray = ['<?xml version="1.0" encoding="UTF-8"?>']
	lines.append(
		'<testsuites name="GutTests" failures="%d" tests="%d">' % [totals.failing, totals.tests]
	)
	for script: Results.ScriptResult in results.scripts:
		var counts: Array = [script.tests.size(), script.count("fail"), script.count("pending")]
		var head: String = '\t<testsuite name="%s" ' % script.name.xml_escape(true)
		head += 'tests="%d" failures="%d" skipped="%d" ' % counts
		lines.append(head + 'time="%.6f">' % script.seconds())
		for test: Results.TestResult in script.tests:
			lines.append(_test_to_xml(test, script.name))
		lines.append("\t</testsuite>")
	lines.append("</testsuites>\n")
	return "\n".join(lines)


## Writes the file, making its folder. Returns an empty text, or what went wrong.
static func write(results: Results, path: String) -> String:
	var full: String = ProjectSettings.globalize_path(path)
	DirAccess.make_dir_recursive_absolute(full.get_base_dir())
	var file: FileAccess = FileAccess.open(full, FileAccess.WRITE)
	if file == null:
		var reason: String = error_string(FileAccess.get_open_error())
		return "cannot write the JUnit file %s: %s" % [full, reason]
	file.store_string(to_xml(results))
	return ""


static func _test_to_xml(test: Results.TestResult, script_name: String) -> String:
	var head: String = '\t\t<testcase name="%s" ' % test.name.xml_escape(true)
	head += 'assertions="%d" status="%s" ' % [test.asserts(), test.status()]
	head += 'classname="%s" time="%.6f">' % [script_name.xml_escape(true), test.seconds]
	var body: String = ""
	if test.status() == "fail":
		body = _element("failure", "failed", test.fails)
	elif test.status() == "pending":
		body = _element("skipped", "pending", test.pendings)
	return head + body + "</testcase>"


static func _element(tag: String, message: String, texts: PackedStringArray) -> String:
	var text: String = "\n".join(texts)
	# XML knows no control characters but tab, line feed and carriage return.
	for code: int in range(1, 32):
		if code not in [9, 10, 13]:
			text = text.replace(String.chr(code), "")
	return '<%s message="%s">%s</%s>' % [tag, message, text.xml_escape(), tag]
