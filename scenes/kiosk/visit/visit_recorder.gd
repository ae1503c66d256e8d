# SPDX-License-Identifier: MIT
class_name VisitRecorder
extends RefCounted
## Writes down what the log keeps of the visit that is on.

var visits: VisitLog
var frames := FrameCount.new()
## The line of the last visit; empty: none yet.
var last_line: String = ""

var _record: VisitRecord
var _seen_stations: Dictionary[int, bool] = {}


func _init(visit_log: VisitLog) -> void:
	visits = visit_log
	last_line = visits.lines.get_last_line()


## A visit begins; returns its number.
func begin(mode: String) -> int:
	_record = VisitRecord.new()
	_record.mode = mode
	_record.language = TranslationServer.get_locale()
	_seen_stations.clear()
	frames.clear()
	visits.begin(_record)
	return _record.number


## Time passes, `seconds` of it for the visit.
func pass_time(seconds: float) -> void:
	if _record != null:
		_record.duration += seconds


## The visitor saw a picture that took so long where one should take `period`.
func see_picture(seconds: float, period: float) -> void:
	frames.add(seconds, period)


func see_station(index: int) -> void:
	_seen_stations[index] = true


## The view was put straight.
func see_reset() -> void:
	if _record != null:
		_record.resets += 1


## The visit is over. Returns its line.
func finish(director: VisitDirector, how: StringName) -> String:
	if _record == null:
		return ""
	_record.language = TranslationServer.get_locale()
	_record.content = director.content
	_record.reached = VisitDirector.NAMES[director.reached]
	_record.stations = _seen_stations.size()
	_record.least_fps = frames.least_fps
	_record.late_frames = frames.late
	_record.end = how
	visits.finish(_record)
	last_line = _record.line()
	_record = null
	return last_line
