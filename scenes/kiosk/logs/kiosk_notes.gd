# SPDX-License-Identifier: MIT
class_name KioskNotes
extends Node
## Keeps the exhibit's log, listens to the engine's errors and gives signs of life.

const LOG_NAME: String = "kiosk.log"
## Between two looks at errors and at what could not be written, seconds.
const LOOK_SECONDS: float = 5.0

var visits: VisitLog
var errors := RecentErrors.new()
## Asked for what the sign of life says beside the rest: a Dictionary.
var words := Callable()

var _log: RotatingLog
var _heartbeat: Heartbeat
var _since_beat: float = INF
var _since_look: float = 0.0


func _enter_tree() -> void:
	OS.add_logger(errors)


func _exit_tree() -> void:
	OS.remove_logger(errors)
	if _heartbeat != null:
		_heartbeat.wait()


func _process(delta: float) -> void:
	_since_beat += delta
	if _since_beat >= Heartbeat.EVERY_SECONDS and _heartbeat != null:
		_since_beat = 0.0
		_heartbeat.beat(_words())
	_since_look += delta
	if _since_look >= LOOK_SECONDS:
		_since_look = 0.0
		_look()


## Opens the logs where the settings want them, and closes what the last run left open.
func open(config: KioskConfig) -> void:
	var folder := config.get_log_folder()
	DirAccess.make_dir_recursive_absolute(folder)
	var last := Heartbeat.read(folder)
	var seen: float = last["time"] if last.get("time") is float else 0.0
	var count := config.whole("log_count")
	_log = RotatingLog.new(folder.path_join(LOG_NAME), config.get_log_bytes(), count)
	visits = VisitLog.new(folder, config.get_log_bytes(), count, seen)
	_heartbeat = Heartbeat.new(folder)
	note("start, version %s, settings of %s" % [ProgramVersion.text(), config.path])
	note("in effect: " + config.describe())
	for complaint in config.complaints:
		push_warning(complaint)
	if not config.get_pin().is_set():
		note("no PIN is set: the hotkey opens the operator's panel")


func note(text: String) -> void:
	print("kiosk: ", text)
	_log.note(text)


## The last sign of life, before the program ends.
func close() -> void:
	_look()
	_heartbeat.beat_now(_words())


## Why logs cannot be written; empty: they can.
func get_fault() -> String:
	return _log.fault if not _log.fault.is_empty() else visits.lines.fault


func _look() -> void:
	for text in errors.take_fresh():
		_log.note("error: " + text)
	_log.flush()
	visits.lines.flush()


func _words() -> Dictionary:
	var texts := errors.get_texts()
	var told: Dictionary = words.call()
	told["last_error"] = texts[0].left(300) if not texts.is_empty() else ""
	told["log_fault"] = get_fault().left(300)
	told["visits_today"] = visits.get_count_today()
	return told
