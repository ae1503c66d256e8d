# SPDX-License-Identifier: MIT
class_name Supervisor
extends Node
## Keeps the exhibit running: starts the program, watches its sign of life, ends one that hangs, and
## starts it again. The same program does it, without a window, so that nothing else is needed.

const LOG_NAME: String = "supervisor.log"
## So often it looks, per second.
const LOOKS_PER_SECOND: int = 4
const HEALTH_SECONDS: float = 5.0
## So long it looks whether a program of before still lives, seconds.
const LEFTOVER_SECONDS: float = 4.0

var _config: KioskConfig
var _policy := SupervisorPolicy.new()
var _log: RotatingLog
var _health: HealthFile
var _folder: String
var _pid: int = -1
var _beat: Dictionary = {}
var _next_health: float = 0.0
var _runtime_was_lost: bool = false


func _ready() -> void:
	Engine.max_fps = LOOKS_PER_SECOND
	_config = KioskConfig.of_program()
	_folder = _config.get_log_folder()
	DirAccess.make_dir_recursive_absolute(_folder)
	_log = RotatingLog.new(
		_folder.path_join(LOG_NAME), _config.get_log_bytes(), _config.whole("log_count")
	)
	_health = HealthFile.new(_folder, 1e6 * _config.number("least_free_megabytes"))
	_policy.start_seconds = _config.number("start_seconds")
	_policy.hang_seconds = _config.number("hang_seconds")
	_policy.well_seconds = _config.number("well_seconds")
	_note("supervisor %s; settings from %s" % [ProgramVersion.text(), _config.path])
	OS.set_environment(Supervision.VARIABLE, "1")
	SteadyMemory.prepare()
	set_process(false)
	await _end_leftover()
	set_process(true)


func _process(_delta: float) -> void:
	var now := _now()
	if _policy.is_running():
		_watch(now)
	match _policy.advise(now):
		SupervisorPolicy.Action.START:
			_start(now)
		SupervisorPolicy.Action.KILL:
			_note(_policy.last_event + "; it is killed")
			OS.kill(_pid)
		SupervisorPolicy.Action.END:
			_tell("ended")
			get_tree().quit()
	if now >= _next_health:
		_tell(_state())


func _start(now: float) -> void:
	var again := "1" if _runtime_was_lost else "0"
	OS.set_environment(Supervision.AGAIN_VARIABLE, again)
	# What it says is looked at for changes only: the old one counts as none.
	_beat = Heartbeat.read(_folder)
	_pid = OS.create_process(OS.get_executable_path(), ProgramCommand.of_program(_config))
	if _pid > 0:
		_policy.note_start(now)
		_note("started, process %d" % _pid)
	else:
		_policy.note_no_start(now)
		_note(_policy.last_event)
	_tell(_state())


func _watch(now: float) -> void:
	# Before the look at the process: the last words of one that ends are read for sure.
	var is_alive := OS.is_process_running(_pid)
	var beat := Heartbeat.read(_folder)
	if beat.get("pid") == float(_pid) and beat.hash() != _beat.hash():
		_beat = beat
		_policy.note_beat(now)
	if not is_alive:
		_end(now)


func _end(now: float) -> void:
	var status := OS.get_process_exit_code(_pid)
	var by_operator: bool = _beat.get("leaving", "") == "operator"
	_policy.note_end(status, by_operator, now)
	_runtime_was_lost = status in [ExitStatus.RUNTIME_LOST, ExitStatus.RUNTIME_MISSING]
	_note(
		"process %d: %s; next start in %.0f s" % [_pid, _policy.last_event, _policy.get_wait(now)]
	)
	_tell(_state())


# A supervisor that was killed leaves its program behind. Its number alone is no proof: it is ended
# only when it also still gives signs of life.
func _end_leftover() -> void:
	var before := Heartbeat.read(_folder)
	if before.is_empty():
		return
	for i in ceili(LEFTOVER_SECONDS * LOOKS_PER_SECOND):
		await get_tree().create_timer(1.0 / LOOKS_PER_SECOND).timeout
		var present := Heartbeat.read(_folder)
		if not present.is_empty() and present.get("beat") != before.get("beat"):
			var pid := _whole(present.get("pid"))
			_note("process %d of an earlier supervisor still runs; it is ended" % pid)
			if pid > 1:
				OS.kill(pid)
			return


func _whole(value: Variant) -> int:
	var number: float = value if value is float else 0.0
	return roundi(number)


func _state() -> String:
	if _policy.has_beaten():
		return "running"
	return "starting" if _policy.is_running() else "waiting"


func _tell(state: String) -> void:
	_next_health = _now() + HEALTH_SECONDS
	_log.flush()
	_health.write(state, _beat, _policy, _log.fault)


func _note(text: String) -> void:
	print("supervisor: ", text)
	_log.note(text)


func _now() -> float:
	return Time.get_ticks_msec() * 1e-3
