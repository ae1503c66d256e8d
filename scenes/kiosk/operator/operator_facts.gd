# SPDX-License-Identifier: MIT
class_name OperatorFacts
extends RefCounted
## What the operator's panel tells about the program.

const NOTHING: String = "–"

var config: KioskConfig
var content: ExhibitContent
var director: VisitDirector
var recorder: VisitRecorder
var notes: KioskNotes

var _started: float = Time.get_ticks_msec() * 1e-3


func tell() -> Dictionary[String, String]:
	var told: Dictionary[String, String] = {
		"State": _state(),
		"Headset": _headset(),
		"Renderer": RenderingServer.get_current_rendering_method(),
		"Graphics card": RenderingServer.get_video_adapter_name(),
		"Pictures per second": "%d" % roundi(Engine.get_frames_per_second()),
		"Late pictures": "%d" % recorder.frames.late,
		"Visits today": "%d" % recorder.visits.get_count_today(),
		"Running for": duration(Time.get_ticks_msec() * 1e-3 - _started),
		"Version": ProgramVersion.text(),
		"Settings": config.path,
		"Wrong settings": "%d" % config.complaints.size(),
		"Logs": ProjectSettings.globalize_path(config.get_log_folder()),
		"Log trouble": notes.get_fault(),
	}
	for title in told:
		told[title] = NOTHING if told[title].is_empty() else told[title]
	return told


## Hours and minutes, such as 3:05.
static func duration(seconds: float) -> String:
	var minutes := floori(seconds / 60.0)
	return "%d:%02d h" % [floori(minutes / 60.0), minutes % 60]


func _state() -> String:
	var told := _steps()[director.state]
	var left := director.get_seconds_left()
	return told if not is_finite(left) else "%s, %d s" % [told, ceili(left)]


func _headset() -> String:
	var session := content.get_session()
	if session == null:
		return NOTHING
	var system := ""
	if session.get_interface() != null:
		system = str(session.get_interface().get_system_info().get("XRRuntimeName", ""))
	return "%s %s" % [_sessions()[session.state], system]


# In the order of VisitDirector.State.
func _steps() -> PackedStringArray:
	return [
		tr("calling visitors"),
		tr("language"),
		tr("health notice"),
		tr("choice"),
		tr("on a visit"),
		tr("thanking"),
	]


# In the order of XrSession.State.
func _sessions() -> PackedStringArray:
	return [tr("none"), tr("opening"), tr("shown"), tr("in focus"), tr("lost")]
