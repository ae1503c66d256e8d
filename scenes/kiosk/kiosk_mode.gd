# SPDX-License-Identifier: MIT
class_name KioskMode
extends RefCounted
## Whether the program runs as an exhibit: nobody leaves it then but the operator, nothing is
## remembered of a visitor, and the window stays as it is.

static var _on: bool = false


static func is_on() -> bool:
	return _on


## The exhibit switches this on while it is there.
static func set_on(value: bool) -> void:
	_on = value
