# SPDX-License-Identifier: MIT
class_name RidePace
extends RefCounted
## How much proper time passes in a second of the viewer's: in step with the place, so that far and
## near a fall is neither dull nor over in a moment, and slower, faster, backwards or not at all as
## one likes.

## Share of the free-fall time r^1.5 that passes each second.
const SHARE: float = 0.15
const LEAST_STEP: int = -6
const LARGEST_STEP: int = 4

var paused: bool = false
var reversed: bool = false

var _step: int = 0


## Proper time per second at a radius, without pause and direction; in r_s/c.
func rate(radius: float) -> float:
	return SHARE * pow(radius, 1.5) * get_factor()


## Proper time for `seconds`.
func passed(radius: float, seconds: float) -> float:
	if paused:
		return 0.0
	return rate(radius) * seconds * (-1.0 if reversed else 1.0)


## The slow-motion factor that was chosen; 1 is the usual pace.
func get_factor() -> float:
	return pow(2.0, _step)


## The factor in words: 4, 1, 1/2.
func get_factor_text() -> String:
	return "1/%d" % (1 << -_step) if _step < 0 else "%d" % (1 << _step)


func change(steps: int) -> void:
	_step = clampi(_step + steps, LEAST_STEP, LARGEST_STEP)


func reset() -> void:
	paused = false
	reversed = false
	_step = 0
