# SPDX-License-Identifier: MIT
class_name SkyLabels
extends Control
## Writes names of stars and constellations beside their images, bent like the sky they belong to.
##
## Lay it over the whole viewport whose camera sees the sky. Names come from the addon's own tables
## unless it is given others.

@export var sky: BlackHoleSky
## The camera; empty: the viewport's current one.
@export var camera: Camera3D
## Names of stars up to this V magnitude.
@export_range(-2.0, 4.5, 0.1, "suffix:mag") var faintest: float = 2.5
@export var stars_shown: bool = true
@export var constellations_shown: bool = false
## Of the constellations' names, such as [code]la[/code] or [code]de[/code]; empty: the program's.
@export var language: String = ""
## Of the second images, inside the Einstein ring, as well.
@export var second_images: bool = false
@export var star_colour := Color(0.75, 0.82, 0.95, 0.9)
@export var constellation_colour := Color(0.35, 0.62, 0.75, 0.9)
## Pixels in a picture of 720 rows.
@export_range(6.0, 40.0, 0.5, "suffix:px") var font_size: float = 13.0

## While it is empty, the addon's own is read as soon as stars are shown.
var stars := StarNames.new()
## While it is empty, the addon's own is read as soon as constellations are shown.
var figures := ConstellationFigures.new()

var _taken: Array[Rect2] = []


func _init() -> void:
	mouse_filter = MOUSE_FILTER_IGNORE
	set_anchors_preset(PRESET_FULL_RECT)


func _process(_delta: float) -> void:
	if is_visible_in_tree():
		queue_redraw()


func _draw() -> void:
	var eye := camera if camera != null else get_viewport().get_camera_3d()
	if sky == null or eye == null:
		return
	_taken.clear()
	_read_tables()
	if stars_shown:
		for i in stars.count_to(faintest):
			for order in 2 if second_images else 1:
				_write(eye, stars.directions[i], order, stars.names[i], star_colour, false)
	if constellations_shown:
		var spoken := language if not language.is_empty() else TranslationServer.get_locale()
		for figure in figures.figures:
			for label in figure.labels:
				_write(eye, label, 0, figure.name(spoken), constellation_colour, true)


## A table that was refused says so once, and is not read again.
func _read_tables() -> void:
	if stars_shown and stars.names.is_empty() and stars.error.is_empty():
		stars = StarNames.load_file()
		if not stars.error.is_empty():
			push_warning(stars.error)
	if constellations_shown and figures.figures.is_empty() and figures.error.is_empty():
		figures = ConstellationFigures.load_file()
		if not figures.error.is_empty():
			push_warning(figures.error)


## Nearer names come first; what would lie over another is left out.
func _write(
	eye: Camera3D, direction: Vector3, order: int, text: String, colour: Color, centred: bool
) -> void:
	var at := sky.project_image(eye, direction, order)
	if not at.is_finite() or not get_rect().has_point(at):
		return
	var font := get_theme_default_font()
	var pixels := maxi(roundi(font_size * maxf(size.y / 720.0, 0.7)), 6)
	var extent := font.get_string_size(text, HORIZONTAL_ALIGNMENT_LEFT, -1.0, pixels)
	var left := at + Vector2(-0.5 * extent.x, 0.0) if centred else at + Vector2(0.6, 0.3) * pixels
	var box := Rect2(left - Vector2(0.0, font.get_ascent(pixels)), extent)
	for other in _taken:
		if other.intersects(box):
			return
	_taken.append(box)
	draw_string(font, left, text, HORIZONTAL_ALIGNMENT_LEFT, -1.0, pixels, colour)
