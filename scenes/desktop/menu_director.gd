# SPDX-License-Identifier: MIT
class_name MenuDirector
extends Node
## Opens the menu and its pages over the sky, and lets the visit rest while one of them is open.

signal tour_asked
signal photo_asked
signal quit_asked

@export var menu: MainMenu
@export var help: HelpOverlay
@export var settings: MenuScreen
@export var cards: MenuScreen
@export var credits: MenuScreen
@export var panel: SkyPanel
@export var controls: ViewControls
@export var router: ActionRouter
@export var pointer: IdlePointer
## What lies over the sky and gives way to the pages.
@export var display: Control
## What stands still meanwhile.
@export var resting: Array[Node]

var _pages: Dictionary[StringName, MenuScreen] = {}
var _from_menu: bool = false


func _ready() -> void:
	_pages = {
		MainMenu.CONTROLS: help,
		MainMenu.SETTINGS: settings,
		MainMenu.CARDS: cards,
		MainMenu.CREDITS: credits,
	}
	menu.chosen.connect(_on_chosen)
	menu.visibility_changed.connect(_hold)
	for page: MenuScreen in _pages.values():
		page.visibility_changed.connect(_hold)
		page.closed.connect(_on_page_closed)
	panel.visibility_changed.connect(_hold)


## The title, before a visit has begun.
func show_title() -> void:
	menu.paused = false
	menu.open()


func toggle_menu() -> void:
	if menu.visible:
		menu.close()
	elif not is_page_open():
		panel.hide()
		menu.paused = true
		menu.open()


func toggle_page(item: StringName) -> void:
	var page := _pages[item]
	if page.visible:
		page.close()
	elif not is_page_open():
		_open(page, menu.visible)


## Whether a page lies over the sky; the menu itself is none.
func is_page_open() -> bool:
	return _pages.values().any(func(page: MenuScreen) -> bool: return page.visible)


func _open(page: MenuScreen, from_menu: bool) -> void:
	_from_menu = from_menu
	menu.hide()
	page.open()


func _on_chosen(item: StringName) -> void:
	if _pages.has(item):
		_open(_pages[item], true)
		return
	match item:
		MainMenu.QUIT:
			quit_asked.emit()
		MainMenu.EFFECTS:
			panel.open()
		MainMenu.TOUR:
			tour_asked.emit()
		MainMenu.PHOTO:
			photo_asked.emit()


func _on_page_closed() -> void:
	if _from_menu:
		menu.open()


func _hold() -> void:
	var covered := menu.visible or is_page_open()
	controls.listening = not covered
	controls.keys_listening = not panel.visible
	router.restricted = covered
	router.gamepad_restricted = panel.visible
	display.visible = not covered
	for node in resting:
		node.set_process(not covered)
	pointer.kept = covered
	pointer.wake()
