# SPDX-License-Identifier: MIT
class_name VisitRecord
extends RefCounted
## What the log keeps of a visit: nothing that tells who it was.

const HEAD: String = (
	"number,start,duration_s,language,mode,content,reached,stations,least_fps,late_frames,"
	+ "resets,end"
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


func to_data() -> Dictionary:
	return {"number": number, "start": start, "language": language, "mode": mode}


## One that began and whose end nobody saw; null when the data are none.
static func from_data(data: Variant) -> VisitRecord:
	if not data is Dictionary:
		return null
	var kept: Dictionary = data
	if not (kept.get("number") is float and kept.get("start") is String):
		return null
	var record := VisitRecord.new()
	var counted: float = kept["number"]
	record.number = roundi(counted)
	record.start = kept["start"]
	record.language = str(kept.get("language", ""))
	record.mode = str(kept.get("mode", ""))
	record.end = CUT
	return record
