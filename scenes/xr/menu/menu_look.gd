# SPDX-License-Identifier: MIT
class_name MenuLook
extends RefCounted
## Colours of the menu and how its boxes are drawn.

## So dark and dense that words can be read before the brightest sky.
const PANEL := Color(0.024, 0.032, 0.056, 0.995)
const RIM := Color(0.62, 0.74, 1.0, 0.22)
const BOX := Color(0.105, 0.13, 0.19)
const TEXT := Color(0.92, 0.95, 1.0)
const SOFT := Color(0.72, 0.79, 0.92)
const GREY := Color(0.64, 0.69, 0.77)
## Of what is pointed at, switched on, or refused.
const ACCENT := Color(1.0, 0.78, 0.42)
const ON_ACCENT := Color(0.05, 0.045, 0.03)


## A box with round corners.
static func box(fill: Color, rim := Color.TRANSPARENT) -> StyleBoxFlat:
	var style := StyleBoxFlat.new()
	style.bg_color = fill
	style.corner_detail = 12
	style.border_color = rim
	return style
