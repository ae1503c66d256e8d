# SPDX-License-Identifier: MIT
class_name FormulaLabel
extends Control
## Shows a formula, in the language that [FormulaParser] reads.

@export var formula: String = "":
	set(value):
		formula = value
		_lay_out()
@export_range(9, 96, 1, "suffix:px") var font_size: int = 24:
	set(value):
		font_size = value
		_lay_out()
@export var colour := Color.WHITE:
	set(value):
		colour = value
		_lay_out()

var _box := FormulaBox.new()


func _init() -> void:
	mouse_filter = MOUSE_FILTER_IGNORE


func _notification(what: int) -> void:
	if what == NOTIFICATION_THEME_CHANGED:
		_lay_out()


func _get_minimum_size() -> Vector2:
	return Vector2(_box.width, _box.get_height()).ceil()


func _draw() -> void:
	_box.draw(self, Vector2(0.0, _box.ascent))


func _lay_out() -> void:
	var parser := FormulaParser.new()
	var style := FormulaStyle.with(get_theme_default_font(), font_size, colour)
	_box = parser.parse(formula, style)
	if not parser.error.is_empty():
		push_warning("Formula: %s." % parser.error)
	update_minimum_size()
	queue_redraw()
