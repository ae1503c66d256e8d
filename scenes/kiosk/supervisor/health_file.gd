# SPDX-License-Identifier: MIT
class_name HealthFile
extends RefCounted
## Tells those who look after the exhibit how it is, in one small JSON file that is replaced whole.

const FILE_NAME: String = "health.json"

var _path: String
var _least_free: float
var _state: String
var _since: String


## `least_free`: bytes; with less room on the disk it warns.
func _init(folder: String, least_free: float) -> void:
	_path = folder.path_join(FILE_NAME)
	_least_free = least_free


## Writes how things are: the state of the program, what it said last (`beat`), what the supervisor
## knows (`policy`).
func write(state: String, beat: Dictionary, policy: SupervisorPolicy, fault: String) -> Error:
	var now := Time.get_datetime_string_from_system(false, true)
	if state != _state:
		_state = state
		_since = now
	var free := _free_bytes()
	var health := {
		"state": state,
		"since": _since,
		"updated": now,
		"version": ProgramVersion.text(),
		"restarts": policy.restarts,
		"failures_in_a_row": policy.failures,
		"last_event": policy.last_event,
		"step": beat.get("step", ""),
		"last_visit": beat.get("last_visit", ""),
		"visits_today": roundi(str(beat.get("visits_today", 0)).to_float()),
		"last_error": beat.get("last_error", ""),
		"log_fault": fault if not fault.is_empty() else str(beat.get("log_fault", "")),
		"free_megabytes": roundi(free / 1e6),
		"low_disk": free < _least_free,
	}
	return AtomicFile.write(_path, JSON.stringify(health, "\t", false) + "\n")


func _free_bytes() -> float:
	var folder := DirAccess.open(_path.get_base_dir())
	return float(folder.get_space_left()) if folder != null else 0.0
