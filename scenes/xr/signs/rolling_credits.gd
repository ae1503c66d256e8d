# SPDX-License-Identifier: MIT
class_name RollingCredits
extends Node
## The credits before the visitor, one entry after the other, each for as long as it takes to read.

const LEAST_SECONDS: float = 2.0
const SECONDS_PER_WORD: float = 0.35

@export var board: VisitSign

var _left: Array[CreditsEntry] = []
var _seconds: float = 0.0


func _process(delta: float) -> void:
	if not is_on():
		return
	_seconds -= delta
	if _seconds <= 0.0:
		_left.pop_front()
		_show_first()


func is_on() -> bool:
	return not _left.is_empty()


## Starts from the first entry, or ends.
func toggle() -> void:
	if is_on():
		_left.clear()
		board.clear()
	else:
		_left = CreditsText.entries()
		_show_first()


## How long an entry stays.
static func reading_time(entry: CreditsEntry) -> float:
	var words := (entry.title + " " + entry.text).replace("\n", " ").split(" ", false)
	return LEAST_SECONDS + SECONDS_PER_WORD * words.size()


func _show_first() -> void:
	if not is_on():
		return
	_seconds = reading_time(_left[0])
	board.say("%s\n\n%s" % [_left[0].title, _left[0].text], _seconds)
