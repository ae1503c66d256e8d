# SPDX-License-Identifier: MIT
class_name VisitMemory
extends RefCounted
## Keeps where the visitor is while the program starts again after the loss of its runtime.

const FILE: String = "user://headset_place.json"


## Writes the hole's size (metres) and place and where the room stands; whole or not at all.
static func store(radius: float, hole: Vector3, room: Transform3D, file: String = FILE) -> void:
	var rows: Array[float] = []
	for column: Vector3 in [room.basis.x, room.basis.y, room.basis.z, room.origin]:
		rows.append_array(_numbers_of(column))
	var kept := {"radius": radius, "hole": _numbers_of(hole), "room": rows}
	AtomicFile.write(file, JSON.stringify(kept, "", false, true) + "\n")


## Puts the hole back and returns where the room stood; null when nothing (sensible) was kept. What
## was kept is forgotten.
static func recall(sky: BlackHoleSky, file: String = FILE) -> Variant:
	var text := AtomicFile.read(file, SettingsFile.is_whole)
	if text.is_empty():
		return null
	AtomicFile.remove(file)
	var kept: Dictionary = JSON.parse_string(text)
	var radius := _numbers([kept.get("radius")], 1)
	var hole := _numbers(kept.get("hole"), 3)
	var room := _numbers(kept.get("room"), 12)
	if radius.is_empty() or hole.is_empty() or room.is_empty():
		return null
	var columns: Array[Vector3] = []
	for i in 4:
		columns.append(Vector3(room[3 * i], room[3 * i + 1], room[3 * i + 2]))
	var stands := Transform3D(columns[0], columns[1], columns[2], columns[3])
	var place := Vector3(hole[0], hole[1], hole[2])
	var small := HoleInRoom.LEAST_RADIUS - 1e-3
	# Numbers may be finite in JSON and not in single precision.
	if not (stands.is_finite() and place.is_finite() and radius[0] >= small and radius[0] < 1e3):
		return null
	sky.schwarzschild_radius = radius[0]
	sky.global_position = place
	return stands


static func _numbers_of(vector: Vector3) -> Array[float]:
	return [vector.x, vector.y, vector.z]


## So many finite numbers; empty when the value is anything else.
static func _numbers(value: Variant, count: int) -> PackedFloat64Array:
	var listed: Array = value if value is Array else []
	if listed.size() != count or not listed.all(JsonKinds.is_number):
		return []
	return PackedFloat64Array(listed)
