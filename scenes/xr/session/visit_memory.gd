# SPDX-License-Identifier: MIT
class_name VisitMemory
extends RefCounted
## Keeps where the visitor is while the program starts again after the loss of its runtime.

const FILE: String = "user://headset_place.cfg"
const SECTION: String = "place"


## Writes the hole's size (metres) and place and where the room stands; whole or not at all.
static func store(radius: float, hole: Vector3, room: Transform3D, file: String = FILE) -> void:
	var kept := ConfigFile.new()
	kept.set_value(SECTION, "radius", radius)
	kept.set_value(SECTION, "hole", hole)
	kept.set_value(SECTION, "room", room)
	AtomicFile.write(file, kept.encode_to_text())


## Puts the hole back and returns where the room stood; null when nothing (sensible) was kept. What
## was kept is forgotten.
static func recall(sky: BlackHoleSky, file: String = FILE) -> Variant:
	var kept := ConfigFile.new()
	if AtomicFile.read(file, func(text: String) -> bool: return kept.parse(text) == OK).is_empty():
		return null
	AtomicFile.remove(file)
	var radius: Variant = kept.get_value(SECTION, "radius", 0)
	var hole: Variant = kept.get_value(SECTION, "hole", 0)
	var room: Variant = kept.get_value(SECTION, "room", 0)
	if not (radius is float and hole is Vector3 and room is Transform3D):
		return null
	var stands: Transform3D = room
	var metres: float = radius
	var place: Vector3 = hole
	var small := HoleInRoom.LEAST_RADIUS - 1e-3
	if not (stands.is_finite() and place.is_finite() and metres >= small and metres < 1e3):
		return null
	sky.schwarzschild_radius = metres
	sky.global_position = place
	return stands
