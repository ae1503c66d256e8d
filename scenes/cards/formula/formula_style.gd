# SPDX-License-Identifier: MIT
class_name FormulaStyle
extends RefCounted
## The fonts, size and colour in which a part of a formula is set.

## How much smaller scripts are, and the least size, pixels.
const SCRIPT_SCALE: float = 0.7
const LEAST_SIZE: int = 9
## The slant of variables: what italics there are, the engine's font has none.
const SLANT: float = 0.2

var upright: Font
var slanted: Font
var size: int = 22
var colour := Color.WHITE


static func with(font: Font, pixels: int, colour_of_ink: Color) -> FormulaStyle:
	var style := new()
	style.upright = font
	var italic := FontVariation.new()
	italic.base_font = font
	italic.variation_transform = Transform2D(Vector2(1.0, SLANT), Vector2(0.0, 1.0), Vector2.ZERO)
	style.slanted = italic
	style.size = pixels
	style.colour = colour_of_ink
	return style


## For what stands above or below the line.
func script() -> FormulaStyle:
	var style := new()
	style.upright = upright
	style.slanted = slanted
	style.size = maxi(roundi(size * SCRIPT_SCALE), LEAST_SIZE)
	style.colour = colour
	return style


## Width of a fraction bar and of a root's line.
func line_width() -> float:
	return maxf(1.0, size / 16.0)


## Height over the base line at which bars and minus signs lie.
func axis() -> float:
	return 0.3 * size
