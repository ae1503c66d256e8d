# SPDX-License-Identifier: MIT
extends GutTest
## Does not compile, on purpose.


func test_pass_unreachable() -> void:
	var number: int = "a text"
	pass_test("never reached %d" % number)
