# SPDX-License-Identifier: MIT
class_name VisitPages
extends Node
## The pages of the menu of a visit: moving, rides, the sky, what explains it, comfort, language.
##
## What other parts of the scene do is asked of them by name. They tell their present state and why
## they refuse through callables of the same name.

## The part that does this shall do it: one of FALL and those below.
signal asked(id: StringName)

const FIRST: StringName = &"first"
const MOVE: StringName = &"move"
const RIDES: StringName = &"rides"
const SKY: StringName = &"sky"
const EXPLAIN: StringName = &"explain"
const COMFORT: StringName = &"comfort"
const LANGUAGE: StringName = &"language"
const TOUR: StringName = &"tour"
const LEAVE: StringName = &"leave"

const FALL: StringName = &"fall"
const ORBIT_RIGHT: StringName = &"orbit_right"
const ORBIT_LEFT: StringName = &"orbit_left"
const PAUSE_RIDE: StringName = &"pause_ride"
const LEAVE_RIDE: StringName = &"leave_ride"
const RECENTRE: StringName = &"recentre"
const HIGHER: StringName = &"higher"
const LOWER: StringName = &"lower"
const RINGS: StringName = &"rings"
const CARDS: StringName = &"cards"
const PASSTHROUGH: StringName = &"passthrough"
const SPECTATOR: StringName = &"spectator"
const TOUR_START: StringName = &"tour_start"
const TOUR_NEXT: StringName = &"tour_next"
const TOUR_PREVIOUS: StringName = &"tour_previous"
const TOUR_LEAVE: StringName = &"tour_leave"
const CREDITS: StringName = &"credits"
const EXIT: StringName = &"exit"
const OBSERVER: StringName = &"observer"

@export var switches: SkySwitches
@export var disk: DiskSwitches
@export var overlays: SkyOverlays
@export var comfort: Comfort
@export var sky: BlackHoleSky

## What is shown at the right of an item, by its name: a bool, for OBSERVER and SPECTATOR a text.
## An item that needs one and has none is not possible.
var states: Dictionary[StringName, Callable] = {}
## Why an item is not possible now, by its name: a text, translated; empty: it is.
var refusals: Dictionary[StringName, Callable] = {}

## Kept here: its items do not keep it.
var _comforts: ComfortPage


## All pages by name, for XrMenu.set_pages().
func make() -> Dictionary[StringName, MenuPage]:
	if _comforts == null:
		_comforts = ComfortPage.new(comfort)
	return {
		FIRST: _first(),
		MOVE: _move(),
		RIDES: _rides(),
		SKY: _sky_page(),
		EXPLAIN: _explain(),
		TOUR: _tour(),
		COMFORT: MenuPage.of(_translated("Comfort"), _comforts.items(), FIRST),
		LANGUAGE: MenuPage.of(_translated("Language"), LanguagePage.items(), FIRST),
		LEAVE: _leave(),
	}


func _first() -> MenuPage:
	var items: Array[MenuItem] = [
		MenuItem.to_page(_translated("Move"), MOVE),
		MenuItem.to_page(_translated("Rides"), RIDES),
		MenuItem.to_page(_translated("Sky"), SKY),
		MenuItem.to_page(_translated("Explain"), EXPLAIN),
		MenuItem.to_page(_translated("Comfort"), COMFORT),
		MenuItem.to_page(_translated("Language"), LANGUAGE).with_globe(),
	]
	# An exhibit's visitors take the headset off.
	if not KioskMode.is_on():
		items.append(MenuItem.to_page(_translated("Exit"), LEAVE).refused_by(_refusal.bind(EXIT)))
	return MenuPage.of(_translated("Menu"), items)


func _move() -> MenuPage:
	return (
		MenuPage
		. of(
			_translated("Move"),
			[
				_toggle(RINGS, _translated("Rings to jump to")),
				_ask(RECENTRE, _translated("Centre the view")).closing(),
				_ask(HIGHER, _translated("Higher")),
				_ask(LOWER, _translated("Lower")),
			],
			FIRST
		)
	)


func _rides() -> MenuPage:
	return (
		MenuPage
		. of(
			_translated("Rides"),
			[
				_ask(FALL, _translated("Fall in")).closing(),
				_ask(ORBIT_RIGHT, _translated("Orbit, right")).closing(),
				_ask(ORBIT_LEFT, _translated("Orbit, left")).closing(),
				_toggle(PAUSE_RIDE, _translated("Pause")),
				_ask(LEAVE_RIDE, _translated("End the ride")).closing(),
			],
			FIRST
		)
	)


func _sky_page() -> MenuPage:
	return (
		MenuPage
		. of(
			_translated("Sky"),
			[
				MenuItem.toggle(
					&"bending",
					_translated("Bending of light"),
					switches.is_hole_wanted,
					switches.toggle_lensing
				),
				MenuItem.toggle(
					&"disk", _translated("Accretion disk"), _is_disk_shown, disk.toggle
				),
				MenuItem.choice(
					&"disk_look", _translated("Kind of disk"), _disk_title, disk.next_preset
				),
				MenuItem.choice(
					&"background",
					_translated("Background"),
					_background_title,
					switches.next_background
				),
				MenuItem.choice(
					&"orders",
					_translated("Images of a star"),
					_orders_title,
					switches.next_image_orders
				),
				_choice(OBSERVER, _translated("Observer")),
			],
			FIRST
		)
	)


func _explain() -> MenuPage:
	return (
		MenuPage
		. of(
			_translated("Explain"),
			[
				MenuItem.to_page(_translated("Guided tour"), TOUR),
				_toggle(CARDS, _translated("Cards")),
				MenuItem.toggle(
					&"lines",
					_translated("Lines of the hole"),
					_are_lines_shown,
					overlays.toggle_of_hole
				),
				MenuItem.toggle(
					&"redshift", _translated("Colour shift map"), _is_map_shown, _toggle_map
				),
				_toggle(PASSTHROUGH, _translated("See your own room")),
				_choice(SPECTATOR, _translated("Screen shows")),
				_ask(CREDITS, _translated("Credits")).closing(),
			],
			FIRST
		)
	)


func _tour() -> MenuPage:
	return (
		MenuPage
		. of(
			_translated("Guided tour"),
			[
				_ask(TOUR_START, _translated("Start the tour")).closing(),
				_ask(TOUR_NEXT, _translated("Next station")).closing(),
				_ask(TOUR_PREVIOUS, _translated("Previous station")).closing(),
				_ask(TOUR_LEAVE, _translated("End the tour")).closing(),
			],
			EXPLAIN
		)
	)


func _leave() -> MenuPage:
	var stays := MenuItem.to_page(_translated("No, stay"), FIRST)
	var leaves := _ask(EXIT, _translated("Yes, leave")).closing()
	return MenuPage.of(_translated("Leave?"), [stays, leaves], FIRST)


func _ask(id: StringName, words: String) -> MenuItem:
	return MenuItem.action(id, words, asked.emit.bind(id)).refused_by(_refusal.bind(id))


func _toggle(id: StringName, words: String) -> MenuItem:
	var item := MenuItem.toggle(id, words, _state.bind(id), asked.emit.bind(id))
	return item.refused_by(_refusal_with_state.bind(id))


func _choice(id: StringName, words: String) -> MenuItem:
	var item := MenuItem.choice(id, words, _state.bind(id), asked.emit.bind(id))
	return item.refused_by(_refusal_with_state.bind(id))


func _state(id: StringName) -> Variant:
	return states[id].call() if states.has(id) else null


func _refusal(id: StringName) -> String:
	var refusal: String = refusals[id].call() if refusals.has(id) else ""
	return refusal


func _refusal_with_state(id: StringName) -> String:
	return _refusal(id) if states.has(id) else tr("This is not there in this exhibit.")


func _is_disk_shown() -> bool:
	return disk.disk.visible


func _disk_title() -> String:
	return DiskPage.preset_titles()[DiskPresets.NAMES.find(disk.preset)]


func _background_title() -> String:
	match sky.background:
		BlackHoleSky.BACKGROUND_GRID:
			return tr("Grid")
		BlackHoleSky.BACKGROUND_PANORAMA:
			return tr("Milky Way")
	return tr("Stars alone")


func _orders_title() -> String:
	return str(sky.image_orders)


func _are_lines_shown() -> bool:
	return sky.overlays & SkyOverlays.OF_HOLE != 0


func _is_map_shown() -> bool:
	return sky.redshift_map


func _toggle_map() -> void:
	sky.redshift_map = not sky.redshift_map


# Marks a text to be translated when it is shown.
static func _translated(text: String) -> String:
	return text
