# SPDX-License-Identifier: MIT
class_name RedshiftScale
extends RefCounted
## The colours of the redshift map, as colour_of_redshift() of the addon's shaders has them.

## Where the colours end, in doublings of the frequency.
const OCTAVES: float = 2.0
## Lines in a doubling.
const LINES: int = 5

# Linear light.
const _SAME := Color(0.42, 0.42, 0.42)
const _BLUE := Color(0.02, 0.12, 0.85)
const _VIOLET := Color(0.10, 0.015, 0.40)
const _ORANGE := Color(0.75, 0.10, 0.01)
const _DARK_RED := Color(0.10, 0.002, 0.002)


## The display's colour of a frequency ratio g = seen / sent, without lines.
static func colour(g: float) -> Color:
	var octaves := log(maxf(g, 1e-6)) / log(2.0)
	var part := sqrt(clampf(absf(octaves) / OCTAVES, 0.0, 1.0))
	var middle := _BLUE if octaves > 0.0 else _ORANGE
	var far := _VIOLET if octaves > 0.0 else _DARK_RED
	var light := (
		_SAME.lerp(middle, 2.0 * part) if part < 0.5 else middle.lerp(far, 2.0 * part - 1.0)
	)
	return light.linear_to_srgb()


## The same where a line is: black at 1, darker elsewhere.
static func line_colour(g: float) -> Color:
	if is_equal_approx(g, 1.0):
		return Color.BLACK
	var light := colour(g).srgb_to_linear() * 0.4
	return Color(light.r, light.g, light.b).linear_to_srgb()
