# SPDX-License-Identifier: MIT
class_name XrMenu
extends Node3D
## A panel of big buttons before the visitor, one page at a time. Child of the origin, so that it
## stays in the room while the visitor is carried through the world.
##
## Sizes are angles as seen from where it opens: what is legible there is so with every headset.

signal opened
signal closed
## An item has been chosen, and what it does is done.
signal chosen(id: StringName)

const SHEET: PackedScene = preload("res://scenes/xr/menu/menu_sheet.tscn")
## Seconds between two looks whether something else is to be shown.
const REFRESH_SECONDS: float = 0.25

## How far before the head it opens, metres.
@export_range(0.5, 5.0, 0.1, "suffix:m") var distance: float = 1.6
## So much lower than straight ahead.
@export_range(0.0, 30.0, 0.5, "suffix:°") var lower_degrees: float = 8.0
## Size of the panel.
@export_range(20.0, 100.0, 1.0, "suffix:°") var width_degrees: float = 62.0
@export_range(20.0, 100.0, 1.0, "suffix:°") var height_degrees: float = 50.0
## Height of an em of the buttons' words.
@export_range(1.0, 6.0, 0.1, "suffix:°") var text_degrees: float = 2.8
## Width of the panel's picture, pixels.
@export_range(320, 4096, 1, "suffix:px") var pixels_across: int = 1600
## How long a gaze must rest on a button.
@export_range(0.3, 5.0, 0.1, "suffix:s") var dwell: float = 1.3

var surface := PanelSurface.new()
var sheet: MenuSheet

var _pages: Dictionary[StringName, MenuPage] = {}
var _first: StringName
var _present: StringName
var _since_refresh: float = 0.0


func _ready() -> void:
	sheet = SHEET.instantiate()
	surface.dwell = dwell
	surface.resize(_metres(), pixels_across)
	add_child(surface)
	surface.show_content(sheet)
	surface.hovered.connect(_on_hovered)
	sheet.em = roundi(get_em_metres() / surface.width * pixels_across)
	sheet.pressed.connect(_on_pressed)
	sheet.back_pressed.connect(_on_back_pressed)
	visible = false
	set_process(false)
	_show_page()


func _process(delta: float) -> void:
	_since_refresh += delta
	if _since_refresh >= REFRESH_SECONDS:
		refresh()


func _notification(what: int) -> void:
	if what == NOTIFICATION_TRANSLATION_CHANGED and is_node_ready():
		refresh()


## The pages by name, and which one is shown first.
func set_pages(pages: Dictionary[StringName, MenuPage], first: StringName) -> void:
	_pages = pages
	_first = first
	_present = first
	if is_node_ready():
		_show_page()


## Opens on the first page, before a head in the world. A menu that is open comes to the head.
func open(head_pose: Transform3D) -> void:
	var was_open := is_open()
	_stand_before(head_pose)
	if was_open:
		return
	visible = true
	set_process(true)
	_present = _first
	_show_page()
	opened.emit()


func close() -> void:
	if not is_open():
		return
	visible = false
	set_process(false)
	surface.leave()
	closed.emit()


func toggle(head_pose: Transform3D) -> void:
	if is_open():
		close()
	else:
		open(head_pose)


func is_open() -> bool:
	return visible


## Shows another page.
func go_to(page: StringName) -> void:
	if not _pages.has(page):
		push_error("The menu has no page %s." % page)
		return
	_present = page
	_show_page()


## The page that is shown.
func get_page() -> StringName:
	return _present


## Shows how things are now.
func refresh() -> void:
	_since_refresh = 0.0
	if sheet.page == null:
		return
	sheet.hint = tr("Point and press, or look at a button for a moment.")
	if sheet.refresh():
		surface.redraw()


## Height of an em of the buttons' words in the world, metres.
func get_em_metres() -> float:
	return 2.0 * distance * tan(deg_to_rad(0.5 * text_degrees))


func _metres() -> Vector2:
	var half := Vector2(tan(deg_to_rad(0.5 * width_degrees)), tan(deg_to_rad(0.5 * height_degrees)))
	return 2.0 * distance * half


func _show_page() -> void:
	if not _pages.has(_present):
		return
	sheet.show_page(_pages[_present])
	surface.hold_back()
	refresh()
	surface.redraw()


# Upright in the room, turned to the head by its bearing alone.
func _stand_before(head_pose: Transform3D) -> void:
	var room := get_parent_node_3d()
	var head := head_pose
	if room != null:
		head = room.global_transform.affine_inverse() * head_pose
	transform = XrRig.before(head, distance, lower_degrees)


func _on_hovered(button: BaseButton) -> void:
	sheet.light(button)


func _on_pressed(item: MenuItem) -> void:
	if not item.get_refusal().is_empty():
		return
	if item.kind == MenuItem.Kind.PAGE:
		go_to.call_deferred(item.page)
		return
	item.act()
	chosen.emit(item.id)
	if item.closes:
		close.call_deferred()
	else:
		refresh()


func _on_back_pressed() -> void:
	var parent := sheet.page.parent
	if parent.is_empty():
		close.call_deferred()
	else:
		go_to.call_deferred(parent)
