# SPDX-License-Identifier: MIT
class_name HoleCard
extends PointTarget
## A card with a title and a few lines about something at the hole, or only a tag with the title
## while another card is open.
##
## Its measures are those seen from one unit away: whoever places it scales it by its distance.

## It has been chosen while it was a tag.
signal chosen

## Letters are drawn as large as headsets show them at most.
const FONT_PIXELS: int = 48
## A text's width and the space round it, in heights of a line.
const LINES_WIDE: float = 7.6
const PADDING := Vector2(0.45, 0.28)
## Between title and text.
const TITLE_GAP: float = 0.12
const DWELL_SECONDS: float = 1.2
const FILL := Color(0.02, 0.03, 0.06, 0.9)
const EDGE := Color(0.62, 0.74, 1.0, 0.35)
const EDGE_POINTED := Color(0.8, 0.88, 1.0, 1.0)

## Height of a line of text, degrees as seen from where the card is placed for.
var text_degrees: float = 2.6

var _is_open: bool = false
var _is_pointed: bool = false
var _size := Vector2.ONE
var _material := ShaderMaterial.new()

@onready var _panel: MeshInstance3D = $Panel
@onready var _words: SubViewport = $Words
@onready var _title: Label = $Words/Title
@onready var _text: Label = $Words/Text


func _ready() -> void:
	_material.shader = preload("res://scenes/xr/cards/card_panel.gdshader")
	_material.render_priority = 10
	_material.set_shader_parameter(&"fill", FILL)
	_material.set_shader_parameter(&"words", _words.get_texture())
	_panel.material_override = _material
	for label: Label in [_title, _text]:
		label.add_theme_font_override(&"font", ThemeDB.fallback_font)
		label.add_theme_font_size_override(&"font_size", FONT_PIXELS)
	_show_pointed()


## What stands on it, in the visitor's language.
func set_content(title: String, text: String) -> void:
	_title.text = title
	_text.text = text
	_fit()


## Title and text, or the title alone.
func set_open(open: bool) -> void:
	_is_open = open
	_fit()


func is_open() -> bool:
	return _is_open


## Width and height at distance 1.
func get_size() -> Vector2:
	return _size


func distance_along(from: Vector3, direction: Vector3) -> float:
	return distance_to_flat(from, direction, _size) if is_visible_in_tree() else INF


func point_at(_place: Vector3) -> void:
	if not _is_pointed:
		_is_pointed = true
		_show_pointed()


func leave() -> void:
	_is_pointed = false
	_show_pointed()


func dwell_seconds() -> float:
	return DWELL_SECONDS


func what_is_pointed_at() -> Variant:
	return self if _is_pointed and not _is_open else null


func choose() -> bool:
	if _is_open:
		return false
	chosen.emit()
	return true


func _show_pointed() -> void:
	_material.set_shader_parameter(&"edge", EDGE_POINTED if _is_pointed and not _is_open else EDGE)


# Panel round what stands on it. Sizes are worked out in the words' pixels.
func _fit() -> void:
	var font := ThemeDB.fallback_font
	var line := font.get_height(FONT_PIXELS)
	var title := font.get_string_size(_title.text, HORIZONTAL_ALIGNMENT_LEFT, -1, FONT_PIXELS)
	var inner := title.ceil()
	_title.position = PADDING * line
	_title.size = inner
	if _is_open:
		var columns := roundf(LINES_WIDE * line)
		_text.size = Vector2(columns, 0.0)
		var height := _text.get_line_count() * ceilf(line)
		_text.position = _title.position + Vector2(0.0, inner.y + TITLE_GAP * line)
		_text.size = Vector2(columns, height)
		inner = Vector2(maxf(inner.x, columns), inner.y + TITLE_GAP * line + height)
	_text.visible = _is_open
	var pixels := inner + 2.0 * PADDING * line
	_words.size = Vector2i(pixels.ceil())
	_words.render_target_update_mode = SubViewport.UPDATE_ONCE
	var degrees := 2.0 * tan(0.5 * deg_to_rad(text_degrees))
	_size = Vector2(_words.size) * degrees / line
	_panel.scale = Vector3(_size.x, _size.y, 1.0)
	_material.set_shader_parameter(&"extent", _size)
	_material.set_shader_parameter(&"corner", 0.4 * degrees)
	_material.set_shader_parameter(&"border", 0.07 * degrees)
	_show_pointed()
