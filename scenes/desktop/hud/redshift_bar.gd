# SPDX-License-Identifier: MIT
class_name RedshiftBar
extends Control
## The bar of the legend: frequency ratios from 1/4 to 4, evenly in their logarithm.

const BAR_HEIGHT: float = 16.0
## Ratios that are written, and how.
const WRITTEN: Dictionary[float, String] = {0.25: "¼", 0.5: "½", 1.0: "1", 2.0: "2", 4.0: "4"}


## Where a ratio lies on a bar of a width.
static func place(g: float, width: float) -> float:
	return width * (0.5 + log(g) / log(2.0) / (2.0 * RedshiftScale.OCTAVES))


func _draw() -> void:
	_draw_colours()
	var count := roundi(RedshiftScale.OCTAVES) * RedshiftScale.LINES
	for step in range(-count + 1, count):
		var g := pow(2.0, float(step) / RedshiftScale.LINES)
		var x := place(g, size.x)
		var width := 2.0 if step == 0 else 1.0
		draw_rect(Rect2(x - 0.5 * width, 0.0, width, BAR_HEIGHT), RedshiftScale.line_colour(g))
	var font := get_theme_font(&"font", &"Caption")
	var font_size := get_theme_font_size(&"font_size", &"Caption")
	var baseline := BAR_HEIGHT + 3.0 + font.get_ascent(font_size)
	for g: float in WRITTEN:
		var text := WRITTEN[g]
		var width := font.get_string_size(text, HORIZONTAL_ALIGNMENT_LEFT, -1.0, font_size).x
		var x := clampf(place(g, size.x) - 0.5 * width, 0.0, size.x - width)
		draw_string(
			font,
			Vector2(x, baseline),
			text,
			HORIZONTAL_ALIGNMENT_LEFT,
			-1.0,
			font_size,
			get_theme_color(&"font_color", &"Label")
		)


func _draw_colours() -> void:
	var columns := ceili(size.x)
	for column in columns:
		var octaves := ((column + 0.5) / columns - 0.5) * 2.0 * RedshiftScale.OCTAVES
		var x := size.x * column / columns
		# A hair wider, so that no gap shows between columns at any scale.
		var width := minf(size.x / columns + 0.5, size.x - x)
		draw_rect(Rect2(x, 0.0, width, BAR_HEIGHT), RedshiftScale.colour(pow(2.0, octaves)))
