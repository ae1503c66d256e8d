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


## All of these for Mobile, the first few for the others, unless everything is asked for.
static func fewer(parameters: Array, few: int) -> Array:
	return parameters if mobile_alone() is bool else parameters.slice(0, few)


static func is_everything_wanted() -> bool:
	return OS.get_environment("BLACKHOLE_TEST_ALL") == "1"
