# SPDX-License-Identifier: MIT
class_name ThirdsGrid
extends Control
## Lines at the thirds of the picture, to compose by. They are not in the photo.

## Light on a dark line, to be seen on the sky and on the disk alike.
const LINE := Color(1.0, 1.0, 1.0, 0.45)
const UNDER := Color(0.0, 0.0, 0.0, 0.45)


func _init() -> void:
	mouse_filter = MOUSE_FILTER_IGNORE
	resized.connect(queue_redraw)


func _draw() -> void:
	for third: float in [1.0 / 3.0, 2.0 / 3.0]:
		var at := (size * third).floor() + Vector2(0.5, 0.5)
		_line(Vector2(at.x, 0.0), Vector2(at.x, size.y))
		_line(Vector2(0.0, at.y), Vector2(size.x, at.y))


func _line(from: Vector2, to: Vector2) -> void:
	draw_line(from, to, UNDER, 3.0)
	draw_line(from, to, LINE, 1.0)
