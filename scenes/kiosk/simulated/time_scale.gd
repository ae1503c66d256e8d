# SPDX-License-Identifier: MIT
class_name TimeScale
extends RefCounted
## How much faster than in truth the clocks of visits run, for tests: after -- --time-scale=N.

const ARGUMENT: String = "--time-scale="

static var _scale: float = 0.0


static func of_program() -> float:
	if _scale == 0.0:
		_scale = from(CommandLine.of_program())
	return _scale


static func from(arguments: PackedStringArray) -> float:
	return clampf(CommandLine.value(arguments, ARGUMENT).to_float(), 1.0, 1000.0)
