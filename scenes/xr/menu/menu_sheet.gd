# SPDX-License-Identifier: MIT
class_name MenuSheet
extends PanelContainer
## The menu as a 2D scene: a head with title and way back, the page's items, and a foot for why
## something is not possible.

## An item's row has been pressed.
signal pressed(item: MenuItem)
## The row that leads back, or closes the menu, has been pressed.
signal back_pressed

## A page with fewer rows has room left over at its foot: in one column, in two.
const LEAST_ROWS: Dictionary[int, int] = {1: 5, 2: 4}
## The foot's words in the size of the rows'.
const FOOT_SHARE: float = 0.93

var page: MenuPage
## Said in the foot while nothing else is, translated.
var hint: String
## Height of an em of the rows' words, pixels.
var em: int = 52:
	set(to):
		em = to
		if is_node_ready():
			_fit()

var _rows: Array[MenuRow] = []
var _lit: MenuRow

@onready var _lines: VBoxContainer = %Lines
@onready var _back: MenuRow = %Back
@onready var _title: Label = %Title
@onready var _grid: GridContainer = %Grid
@onready var _foot: Label = %Foot


func _ready() -> void:
	_fit()
	_title.add_theme_color_override(&"font_color", MenuLook.SOFT)
	_back.pressed.connect(back_pressed.emit)


## Shows a page.
func show_page(shown: MenuPage) -> void:
	page = shown
	for old in _grid.get_children():
		_grid.remove_child(old)
		old.queue_free()
	_rows.clear()
	_lit = null
	_grid.columns = page.get_columns()
	for item in page.items:
		_add_row(item)
	_keep_heights()
	refresh()


## Shows how things are now; true when something else than before is shown.
func refresh() -> bool:
	var before := _told()
	_back.words = "×  " + tr("Close") if page.parent.is_empty() else "‹  " + tr("Back")
	_back.custom_minimum_size.x = _back.get_needed_width()
	_title.text = tr(page.title)
	for row in _rows:
		row.words = tr(row.item.text)
		row.value = row.item.get_value()
		row.disabled = not row.item.get_refusal().is_empty()
	_tell()
	return _told() != before


## Lights the row that is pointed at, and no other; null: none.
func light(button: BaseButton) -> void:
	_lit = button as MenuRow
	for row in get_rows():
		row.lit = row == _lit
	_tell()


## All rows, the one that leads back first.
func get_rows() -> Array[MenuRow]:
	var rows: Array[MenuRow] = [_back]
	rows.append_array(_rows)
	return rows


## What the foot says: why the lit item cannot be chosen, or what to do here.
func get_foot() -> String:
	return _foot.text


# Everything goes by the words' size.
func _fit() -> void:
	var box := MenuLook.box(MenuLook.PANEL, MenuLook.RIM)
	box.set_content_margin_all(0.7 * em)
	box.set_corner_radius_all(roundi(0.85 * em))
	box.set_border_width_all(maxi(roundi(0.06 * em), 2))
	add_theme_stylebox_override(&"panel", box)
	_lines.add_theme_constant_override(&"separation", roundi(0.36 * em))
	_grid.add_theme_constant_override(&"h_separation", roundi(0.3 * em))
	_grid.add_theme_constant_override(&"v_separation", roundi(0.22 * em))
	_back.em = em
	_back.custom_minimum_size.y = 1.6 * em
	_title.add_theme_font_size_override(&"font_size", em)
	_foot.add_theme_font_size_override(&"font_size", roundi(FOOT_SHARE * em))
	_foot.add_theme_constant_override(&"line_spacing", roundi(-0.12 * em))
	_foot.custom_minimum_size.y = 2.4 * em


func _add_row(item: MenuItem) -> void:
	var row := MenuRow.new()
	row.item = item
	row.em = em
	row.size_flags_horizontal = Control.SIZE_EXPAND_FILL
	row.size_flags_vertical = Control.SIZE_EXPAND_FILL
	row.pressed.connect(pressed.emit.bind(item))
	_grid.add_child(row)
	_rows.append(row)


# Pages with few items do not have taller rows than others.
func _keep_heights() -> void:
	for i in range(ceili(float(_rows.size()) / _grid.columns), LEAST_ROWS[_grid.columns]):
		for column in _grid.columns:
			var room := Control.new()
			room.size_flags_vertical = Control.SIZE_EXPAND_FILL
			room.mouse_filter = Control.MOUSE_FILTER_IGNORE
			_grid.add_child(room)


func _tell() -> void:
	var refusal := ""
	if _lit != null and _lit.item != null:
		refusal = _lit.item.get_refusal()
	var colour := MenuLook.SOFT if refusal.is_empty() else MenuLook.ACCENT
	_foot.add_theme_color_override(&"font_color", colour)
	_foot.text = hint if refusal.is_empty() else refusal


# All that is shown, to see whether it changes.
func _told() -> Array:
	var told := [_title.text, _foot.text, _back.words]
	for row in _rows:
		told.append_array([row.words, row.value, row.disabled])
	return told
