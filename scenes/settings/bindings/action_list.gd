# SPDX-License-Identifier: MIT
class_name ActionList
extends RefCounted
## The actions that a user may bind anew: their names, in groups, and when each of them counts.

## When an action counts: on the way round the hole, in free flight, on a ride along a given way, on
## a ride under thrust.
enum When { ORBIT = 1, FLIGHT = 2, GLIDE = 4, THRUST = 8 }

const RIDE: int = When.GLIDE | When.THRUST
const ALWAYS: int = When.ORBIT | When.FLIGHT | RIDE
## These keep what the project gives them, so that nobody locks himself out.
const FIXED: Array[StringName] = [&"toggle_menu"]
## Actions that count while they are held begin so.
const HELD: PackedStringArray = [
	"orbit_", "approach", "recede", "fly_", "look_", "roll_", "ride_back", "ride_ahead"
]
## A title alone begins a group; else action, title, when it counts, and what the mouse does
## besides.
const ROWS: Array[Array] = [
	["Round the hole"],
	[&"orbit_left", "To the left", When.ORBIT, "across"],
	[&"orbit_right", "To the right", When.ORBIT, "across"],
	[&"orbit_up", "Upwards", When.ORBIT, "along"],
	[&"orbit_down", "Downwards", When.ORBIT, "along"],
	[&"approach", "Nearer", When.ORBIT, "wheel"],
	[&"recede", "Farther", When.ORBIT, "wheel"],
	["Flight and thrust"],
	[&"fly_forward", "Ahead", When.ORBIT | When.FLIGHT | When.THRUST],
	[&"fly_back", "Back", When.ORBIT | When.FLIGHT | When.THRUST],
	[&"fly_left", "Fly left", When.ORBIT | When.FLIGHT | When.THRUST],
	[&"fly_right", "Fly right", When.ORBIT | When.FLIGHT | When.THRUST],
	[&"fly_up", "Fly up", When.FLIGHT | When.THRUST],
	[&"fly_down", "Fly down", When.FLIGHT | When.THRUST],
	[&"fly_fast", "Faster", When.ORBIT | When.FLIGHT],
	["Looking round"],
	[&"look_left", "Look left", When.FLIGHT | RIDE, "across"],
	[&"look_right", "Look right", When.FLIGHT | RIDE, "across"],
	[&"look_up", "Look up", When.FLIGHT | RIDE, "along"],
	[&"look_down", "Look down", When.FLIGHT | RIDE, "along"],
	[&"roll_left", "Roll left", ALWAYS],
	[&"roll_right", "Roll right", ALWAYS],
	[&"toggle_flight", "Orbit or flight; gaze on a ride", ALWAYS],
	[&"reset_view", "First view", ALWAYS],
	["Sky"],
	[&"toggle_lensing", "With and without the hole", ALWAYS],
	[&"next_observer", "Next observer", ALWAYS],
	[&"next_background", "Background", ALWAYS],
	[&"next_image_orders", "Image orders", ALWAYS],
	[&"exposure_up", "Brighter", ALWAYS],
	[&"exposure_down", "Darker", ALWAYS],
	[&"toggle_names", "Constellations and names", ALWAYS],
	[&"toggle_overlays", "Lines of the hole", ALWAYS],
	[&"toggle_disk", "Accretion disk", ALWAYS],
	[&"next_disk", "Next kind of disk", ALWAYS],
	[&"toggle_map", "Map of the whole sky", ALWAYS],
	["Rides"],
	[&"ride_pause", "Pause, go on", RIDE],
	[&"ride_reverse", "Back in time", RIDE],
	[&"ride_slower", "Slower", RIDE],
	[&"ride_faster", "Faster in time", RIDE],
	[&"ride_back", "Fro, while held", When.GLIDE],
	[&"ride_ahead", "To, while held", When.GLIDE],
	[&"ride_leave", "Leave the ride", RIDE],
	["Window"],
	[&"toggle_panel", "Effects, rides, sky, disk", ALWAYS],
	[&"toggle_hud", "Show or hide the display", ALWAYS],
	[&"toggle_help", "Help", ALWAYS],
	[&"toggle_fullscreen", "Full screen", ALWAYS],
]


## All actions that can be bound anew and are in the input map.
static func actions() -> Array[StringName]:
	var found: Array[StringName] = []
	for row in ROWS:
		if row.size() > 1:
			var action: StringName = row[0]
			if InputMap.has_action(action):
				found.append(action)
	return found


static func title_of(action: StringName) -> String:
	for row in ROWS:
		if row[0] == action:
			var title: String = row[1]
			return title
	return "Menu" if FIXED.has(action) else String(action)


## Whether one press could mean both.
static func meet(one: StringName, other: StringName) -> bool:
	if _is_of_ride(one) != _is_of_ride(other) and not (_is_held(one) or _is_held(other)):
		# On a ride the press is for the ride, elsewhere the ride's action does not count.
		return false
	return (_when(one) & _when(other)) != 0


static func _when(action: StringName) -> int:
	for row in ROWS:
		if row[0] == action:
			var when: int = row[2]
			return when
	return ALWAYS


static func _is_of_ride(action: StringName) -> bool:
	return action.begins_with("ride_")


# These are asked for in each frame, past the order in which presses are given out.
static func _is_held(action: StringName) -> bool:
	for beginning in HELD:
		if action.begins_with(beginning):
			return true
	return false
