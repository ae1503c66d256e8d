# SPDX-License-Identifier: MIT
class_name HelpOverlay
extends MenuScreen
## The controls, read from the input map, and the buttons to close it and to fill the screen.

signal fullscreen_asked

## What is explained, which actions do it, what the mouse does beside them, and, where the gamepad
## needs no control of its own, how it gets there; an empty row begins the second column.
const ROWS: Array[Array] = [
	["Go round the hole", [&"orbit_left", &"orbit_right", &"orbit_up", &"orbit_down"], "Drag"],
	["Nearer, farther", [&"approach", &"recede"], "Wheel"],
	["Orbit or free flight", [&"toggle_flight"], ""],
	["Fly", [&"fly_forward", &"fly_left", &"fly_back", &"fly_right"], ""],
	["Fly down, up", [&"fly_down", &"fly_up"], ""],
	["Look round: flight, ride", [&"look_left", &"look_right", &"look_up", &"look_down"], "Drag"],
	["Roll", [&"roll_left", &"roll_right"], ""],
	["Faster, while held", [&"fly_fast"], ""],
	["First view", [&"reset_view"], ""],
	["With and without the hole", [&"toggle_lensing"], ""],
	["Next observer", [&"next_observer"], ""],
	["Background", [&"next_background"], ""],
	["Image orders", [&"next_image_orders"], ""],
	["Darker, brighter", [&"exposure_down", &"exposure_up"], ""],
	[],
	["Effects, rides, sky, disk", [&"toggle_panel"], ""],
	["Constellations and names", [&"toggle_names"], "", "In the panel"],
	["Lines of the hole", [&"toggle_overlays"], "", "In the panel"],
	["Accretion disk, next kind", [&"toggle_disk", &"next_disk"], "", "In the panel"],
	["Map of the whole sky", [&"toggle_map"], "", "In the panel"],
	["Ride: pause, go on", [&"ride_pause"], ""],
	["Ride: back in time", [&"ride_reverse"], ""],
	["Ride: slower, faster", [&"ride_slower", &"ride_faster"], ""],
	["Ride: to and fro, held", [&"ride_back", &"ride_ahead"], "Slider"],
	["Ride: free gaze, hole, back", [&"toggle_flight"], ""],
	["Ride: leave", [&"ride_leave"], ""],
	["Show or hide the display", [&"toggle_hud"], ""],
	["Full screen", [&"toggle_fullscreen"], ""],
	["This help", [&"toggle_help"], "", "In the menu"],
	["Menu", [&"toggle_menu"], ""],
]

@onready var _left: GridContainer = %Left
@onready var _right: GridContainer = %Right
@onready var _panel: PanelContainer = $Panel
@onready var _close: Button = %Close
@onready var _fullscreen: Button = %Fullscreen


func _ready() -> void:
	_close.pressed.connect(close)
	_fullscreen.pressed.connect(fullscreen_asked.emit)


func get_first_focus() -> Control:
	return _close


func _on_open() -> void:
	_fill()
	_fit.call_deferred()


# Large text makes the list larger than a small window.
func _fit() -> void:
	var needed := _panel.get_combined_minimum_size()
	var share := get_viewport_rect().size / needed
	_panel.pivot_offset = 0.5 * _panel.size
	_panel.scale = Vector2.ONE * minf(1.0, minf(share.x, share.y))


# Anew each time: language and bindings may have changed.
func _fill() -> void:
	for column: GridContainer in [_left, _right]:
		for cell in column.get_children():
			cell.free()
	var grid := _left
	_add_row(grid, "", "Keyboard and mouse", "Gamepad", &"Caption")
	for row in ROWS:
		if row.is_empty():
			grid = _right
			_add_row(grid, "", "Keyboard", "Gamepad", &"Caption")
			continue
		var actions: Array[StringName] = []
		var listed: Array = row[1]
		actions.assign(listed)
		var keys := BindingNames.keyboard(actions)
		var mouse: String = row[2]
		if not mouse.is_empty():
			keys = tr(mouse) + BindingNames.BETWEEN + keys
		var what: String = row[0]
		_add_row(grid, what, keys, _gamepad(row, actions))


func _gamepad(row: Array, actions: Array[StringName]) -> String:
	if row.size() > 3:
		var way: String = row[3]
		return way
	return BindingNames.gamepad(actions)


func _add_row(
	grid: GridContainer, what: String, keys: String, pad: String, kind: StringName = &"Label"
) -> void:
	for text: String in [what, keys, pad]:
		var label := Label.new()
		label.text = text
		label.theme_type_variation = kind
		grid.add_child(label)
