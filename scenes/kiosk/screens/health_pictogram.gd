# SPDX-License-Identifier: MIT
class_name HealthPictogram
extends Control
## Draws what needs no words: a head with a headset, and whom it is not for.

enum Sign {
	## A head with a headset.
	HEADSET,
	## Thirteen years and over.
	AGE,
	## Not for those who are unwell.
	UNWELL,
	## Take it off.
	TAKE_OFF,
}

const INK := Color(0.9, 0.93, 1.0)
const ACCENT := Color(1.0, 0.78, 0.42)

@export var picture: Sign = Sign.HEADSET:
	set(value):
		picture = value
		queue_redraw()


func _draw() -> void:
	var unit := minf(size.x, size.y) / 100.0
	draw_set_transform(0.5 * size - Vector2(50.0, 50.0) * unit, 0.0, Vector2.ONE * unit)
	match picture:
		Sign.HEADSET:
			_draw_head(Vector2.ZERO)
			_draw_visor(Vector2.ZERO)
		Sign.AGE:
			_draw_age()
		Sign.UNWELL:
			_draw_unwell()
		Sign.TAKE_OFF:
			_draw_head(Vector2(-14.0, 4.0))
			_draw_visor(Vector2(12.0, -2.0))
			_draw_away()


func _draw_head(shift: Vector2) -> void:
	draw_arc(Vector2(46.0, 46.0) + shift, 28.0, 0.0, TAU, 64, INK, 5.0, true)
	draw_arc(Vector2(46.0, 104.0) + shift, 34.0, 1.12 * PI, 1.88 * PI, 48, INK, 5.0, true)


func _draw_visor(shift: Vector2) -> void:
	var box := StyleBoxFlat.new()
	box.bg_color = ACCENT
	box.set_corner_radius_all(6)
	draw_style_box(box, Rect2(Vector2(50.0, 34.0) + shift, Vector2(36.0, 24.0)))
	if shift == Vector2.ZERO:
		draw_line(Vector2(20.0, 44.0), Vector2(52.0, 44.0), ACCENT, 5.0, true)


# The way that the headset takes.
func _draw_away() -> void:
	draw_line(Vector2(58.0, 78.0), Vector2(92.0, 78.0), ACCENT, 5.0, true)
	draw_line(Vector2(82.0, 68.0), Vector2(93.0, 78.0), ACCENT, 5.0, true)
	draw_line(Vector2(82.0, 88.0), Vector2(93.0, 78.0), ACCENT, 5.0, true)


func _draw_age() -> void:
	draw_arc(Vector2(50.0, 50.0), 42.0, 0.0, TAU, 72, ACCENT, 6.0, true)
	var font := get_theme_default_font()
	var words := "13+"
	var extent := font.get_string_size(words, HORIZONTAL_ALIGNMENT_LEFT, -1.0, 38)
	var place := Vector2(50.0 - 0.5 * extent.x, 50.0 + 0.36 * 38.0)
	draw_string(font, place, words, HORIZONTAL_ALIGNMENT_LEFT, -1.0, 38, INK)


func _draw_unwell() -> void:
	draw_arc(Vector2(50.0, 54.0), 20.0, 0.0, TAU, 48, INK, 5.0, true)
	# Eyes shut tight, and a mouth that is not well.
	draw_line(Vector2(40.0, 48.0), Vector2(46.0, 51.0), INK, 3.5, true)
	draw_line(Vector2(60.0, 48.0), Vector2(54.0, 51.0), INK, 3.5, true)
	draw_arc(Vector2(50.0, 68.0), 7.0, 1.15 * PI, 1.85 * PI, 24, INK, 3.5, true)
	draw_arc(Vector2(50.0, 50.0), 42.0, 0.0, TAU, 72, ACCENT, 6.0, true)
	draw_line(Vector2(20.5, 20.5), Vector2(79.5, 79.5), ACCENT, 6.0, true)
