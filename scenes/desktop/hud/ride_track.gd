# SPDX-License-Identifier: MIT
class_name RideTrack
extends HSlider
## The way of a ride, to be sought with the mouse; a mark tells where the horizon is.

## Where the mark is, 0 to 1; outside of that there is none.
var mark: float = -1.0:
	set(value):
		if mark != value:
			mark = value
			queue_redraw()


func _draw() -> void:
	if mark < 0.0 or mark > 1.0:
		return
	var grabber := get_theme_icon(&"grabber").get_size().x
	var x := 0.5 * grabber + mark * (size.x - grabber)
	draw_rect(Rect2(x - 1.0, 0.0, 2.0, size.y), get_theme_color(&"font_color", &"Warning"))
