# SPDX-License-Identifier: MIT
class_name RendererScope
extends RefCounted
## Which renderers draw what: tests of what does not depend on the renderer are drawn by Mobile
## alone, unless everything is asked for.


## What a script of such tests returns from should_skip_script().
static func mobile_alone() -> Variant:
	if RenderingServer.get_current_rendering_method() == "mobile" or is_everything_wanted():
		return false
	return "drawn by Mobile; ./test --all draws it with every renderer"


## The same for tests of what Mobile and Compatibility may draw differently, but not Mobile and
## Forward+, which share a driver and its shading language.
static func without_forward_plus() -> Variant:
	var method := RenderingServer.get_current_rendering_method()
	if method != "forward_plus" or is_everything_wanted():
		return false
	return "drawn by Mobile and Compatibility; ./test --all draws it with Forward+ too"


## What takes long, and is seen in shorter tests as well as far as each run needs it.
static func with_everything_alone() -> Variant:
	if is_everything_wanted():
		return false
	return "a long test, for ./test --all"


## All of these for Mobile, the first few for the others, unless everything is asked for.
static func fewer(parameters: Array, few: int) -> Array:
	return parameters if mobile_alone() is bool else parameters.slice(0, few)


static func is_everything_wanted() -> bool:
	return OS.get_environment("BLACKHOLE_TEST_ALL") == "1"
