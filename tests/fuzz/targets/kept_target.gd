# SPDX-License-Identifier: MIT
extends FuzzTarget
## What the program itself keeps between two starts, as a power cut may leave it: the state of the
## visits' log and the heartbeat of the exhibit, the place of a visitor in the headset.

const VISITS: Dictionary = {
	"last": 41,
	"today": "2026-01-02",
	"count_today": 3,
	"open": {"number": 41, "start": "2026-01-02T10:11:12", "language": "de", "mode": "headset"}
}
const BEAT: Dictionary = {"beat": 7, "pid": 4711, "time": 1.7e9, "step": "VISIT", "visits_today": 3}
const PLACE: Dictionary = {
	"radius": 0.4, "hole": [0, 1.5, -2], "room": [1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0]
}

## Made once: it takes longer than all else.
var _sky: BlackHoleSky


func _init() -> void:
	file_name = "visits.json"
	is_json = true
	words = ["last", "today", "number", "radius", "1e300", "null", "[", "{"]


func seeds() -> Array[PackedByteArray]:
	# All in one is taken by each of the readers.
	var all := VISITS.merged(BEAT).merged(PLACE)
	return [json(VISITS), json(BEAT), json(PLACE), json(all)]


func read(path: String) -> FuzzAnswer:
	var answer := FuzzAnswer.new()
	var folder := path.get_base_dir()
	var bytes := FileAccess.get_file_as_bytes(path)
	var visits := VisitLog.new(folder, 100000, 1)
	answer.demand(visits.get_last_number() >= 0, "numbers of visits from 0 on")
	answer.demand(visits.get_count_today() >= 0, "none or more visits today")
	var log_file := folder.path_join(VisitLog.LOG_NAME)
	for file: String in [log_file, log_file + ".1"]:
		DirAccess.remove_absolute(file)
	_put(folder.path_join(Heartbeat.FILE_NAME), bytes)
	var beat := Heartbeat.read(folder)
	if beat.is_empty():
		answer.complaints.append("no heartbeat")
	_put(folder.path_join("place.json"), bytes)
	if _sky == null:
		_sky = BlackHoleSky.new()
		(Engine.get_main_loop() as SceneTree).root.add_child(_sky)
	var stands: Variant = VisitMemory.recall(_sky, folder.path_join("place.json"))
	if stands == null:
		answer.complaints.append("no place")
	else:
		var room: Transform3D = stands
		answer.demand(room.is_finite(), "a room that is somewhere")
	answer.demand(is_finite(_sky.schwarzschild_radius), "a size of the hole")
	answer.demand(_sky.global_position.is_finite(), "a place of the hole")
	return answer


func _put(path: String, bytes: PackedByteArray) -> void:
	var file := FileAccess.open(path, FileAccess.WRITE)
	file.store_buffer(bytes)
