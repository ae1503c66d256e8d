# SPDX-License-Identifier: MIT
class_name VisitRecord
extends RefCounted
## What the log keeps of a visit: nothing that tells who it was.

const HEAD: String = (
	"number,start,duration_s,language,mode,content,reached,stations,least_fps,late_frames,"
	+ "resets,end"
)
## Local time as it is written: year, month, day, hour, minute, second.
const START: String = (
	"^[12][0-9]{3}-(0[1-9]|1[0-2])-(0[1-9]|[12][0-9]|3[01])T"
	+ "([01][0-9]|2[0-3]):[0-5][0-9]:[0-5][0-9]$"
)
## How a visit is logged that a crash or a power cut ended.
const CUT: String = "cut"

var number: int = 0
## Local time.
var start: String
var duration: float = 0.0
var language: String
## headset or screen.
var mode: String
var content: String
## The last step that the visitor came to.
var reached: String
## Stations of the tour that were seen.
var stations: int = 0
## Fewest pictures in a second; 0: not counted.
var least_fps: int = 0
var late_frames: int = 0
## How often the view was put straight.
var resets: int = 0
var end: String


## The visit's line in the log.
func line() -> String:
	var cells: PackedStringArray = [
		str(number),
		start,
		str(roundi(duration)),
		language,
		mode,
		content,
		reached,
		str(stations),
		str(least_fps),
		str(late_frames),
		str(resets),
		end,
	]
	return ",".join(cells)


## When it began, seconds since 1970, as if local time were UTC.
func began() -> float:
	# From the first of the month, which every month has.
	var day := start.substr(8, 2).to_int()
	var first := start.left(8) + "01" + start.substr(10)
	return Time.get_unix_time_from_datetime_string(first) + 86400.0 * (day - 1)


func to_data() -> Dictionary:
	return {"number": number, "start": start, "language": language, "mode": mode}


## One that began and whose end nobody saw; null when the data are none.
static func from_data(data: Variant) -> VisitRecord:
	if not data is Dictionary:
		return null
	var kept: Dictionary = data
	if not (kept.get("number") is float and kept.get("start") is String):
		return null
	var begin: String = kept["start"]
	if RegEx.create_from_string(START).search(begin) == null:
		return null
	var record := VisitRecord.new()
	var counted: float = kept["number"]
	record.number = roundi(counted)
	record.start = begin
	record.language = str(kept.get("language", ""))
	record.mode = str(kept.get("mode", ""))
	record.end = CUT
	return record
