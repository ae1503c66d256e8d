# SPDX-License-Identifier: MIT
class_name XrTestCase
extends GutTest
## A test on the simulated headset: each has a visit of its own.

var visit: XrVisit

@warning_ignore("untyped_declaration")
func should_skip_script():
	return XrVisit.missing()


func before_each() -> void:
	visit = XrVisit.new()
	add_child(visit)


func after_each() -> void:
	XrVisit.excuse(get_errors())
	visit.free()


## Begins the visit; false, and a failure, when the session does not come into focus.
func begun() -> bool:
	var well := await visit.begin()
	assert_true(well, "in focus")
	return well
