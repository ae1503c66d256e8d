# SPDX-License-Identifier: MIT
class_name VisitLog
extends RefCounted
## Numbers the visits and writes one line for each into visits.csv, also for one that a crash or a
## power cut ended: what is on is kept in a small file, and found there at the next start.

const LOG_NAME: String = "visits.csv"
const STATE_NAME: String = "visits.json"

var lines: RotatingLog

var _state_path: String
var _last: int = 0
var _today: String
var _count_today: int = 0
var _open: VisitRecord


## `last_seen`: when the program last gave a sign of life, seconds since 1970; 0: unknown.
func _init(folder: String, most_bytes: int, older_count: int, last_seen: float = 0.0) -> void:
	lines = RotatingLog.new(folder.path_join(LOG_NAME), most_bytes, older_count, VisitRecord.HEAD)
	_state_path = folder.path_join(STATE_NAME)
	var state := _read_state()
	_last = maxi(_number_of(lines.get_last_line()), _whole(state.get("last")))
	_today = str(state.get("today", ""))
	_count_today = _whole(state.get("count_today"))
	_close_cut(VisitRecord.from_data(state.get("open")), last_seen)


## Begins a visit and numbers it.
func begin(record: VisitRecord) -> void:
	_last += 1
	record.number = _last
	record.start = Time.get_datetime_string_from_system()
	var day := Time.get_date_string_from_system()
	_count_today = _count_today + 1 if day == _today else 1
	_today = day
	_open = record
	_write_state()


## Ends the visit that is on.
func finish(record: VisitRecord) -> void:
	lines.add(record.line())
	_open = null
	_write_state()


func get_last_number() -> int:
	return _last


func get_count_today() -> int:
	return _count_today if _today == Time.get_date_string_from_system() else 0


func _close_cut(cut: VisitRecord, last_seen: float) -> void:
	if cut == null or cut.number <= _number_of(lines.get_last_line()):
		return
	_last = maxi(_last, cut.number)
	var bias: int = Time.get_time_zone_from_system()["bias"]
	cut.duration = maxf(last_seen - (cut.began() - 60.0 * bias), 0.0)
	finish(cut)


func _number_of(line: String) -> int:
	return line.get_slice(",", 0).to_int()


func _read_state() -> Dictionary:
	var parser := JSON.new()
	var is_object := func(text: String) -> bool:
		var read := parser.parse(text) == OK and parser.data is Dictionary
		return read and not JsonKinds.is_deeper(parser.data, 4)
	if AtomicFile.read(_state_path, is_object).is_empty():
		return {}
	var state: Dictionary = parser.data
	return state


func _write_state() -> void:
	var state := {"last": _last, "today": _today, "count_today": _count_today}
	if _open != null:
		state["open"] = _open.to_data()
	AtomicFile.write(_state_path, JSON.stringify(state) + "\n")


func _whole(value: Variant) -> int:
	var number: float = value if JsonKinds.is_number(value) else 0.0
	return roundi(number)
