# SPDX-License-Identifier: MIT
class_name SupervisorPolicy
extends RefCounted
## When the program is to be started, and when to be killed. It knows no process; times, in seconds,
## and what happens are passed in.

enum Action { NONE, START, KILL, END }

## Wait before the first start after a failure; it doubles with each further one, up to the longest.
const FIRST_WAIT: float = 1.0
const LONGEST_WAIT: float = 60.0
## What lives shorter than this has not come up: also a planned end then counts as a failure.
const BRIEF_SECONDS: float = 10.0

## A start that takes longer has failed.
var start_seconds: float = 90.0
## No sign of life for so long: it hangs.
var hang_seconds: float = 20.0
## Having lived for so long it is well: failures are forgotten.
var well_seconds: float = 300.0

## Starts after the first one.
var restarts: int = 0
## Failures in a row.
var failures: int = 0
## What happened last, for logs and people.
var last_event: String = "starting"

var _is_running: bool = false
var _is_killed: bool = false
var _is_ended: bool = false
var _has_beaten: bool = false
var _started: float = -1.0
var _last_beat: float = 0.0
var _next_start: float = 0.0


## What to do now.
func advise(now: float) -> Action:
	if _is_ended:
		return Action.END
	if not _is_running:
		return Action.START if now >= _next_start else Action.NONE
	if _has_beaten and now - _started >= well_seconds:
		failures = 0
	var patience := hang_seconds if _has_beaten else start_seconds
	if not _is_killed and now - _last_beat >= patience:
		_is_killed = true
		last_event = "hung: no sign of life for %d s" % roundi(patience)
		if not _has_beaten:
			last_event = "did not come up within %d s" % roundi(patience)
		return Action.KILL
	return Action.NONE


## It has been started.
func note_start(now: float) -> void:
	if _started >= 0.0:
		restarts += 1
	_is_running = true
	_is_killed = false
	_has_beaten = false
	_started = now
	_last_beat = now


## It could not even be started.
func note_no_start(now: float) -> void:
	last_event = "could not be started"
	_fail(now)


## A sign of life.
func note_beat(now: float) -> void:
	_has_beaten = true
	_last_beat = now


## It has ended with `status`; `operator`: it had said that the operator ended it.
func note_end(status: int, operator: bool, now: float) -> void:
	var lived := now - _started
	_is_running = false
	if not _is_killed:
		last_event = ExitStatus.describe(status, operator)
	if status == ExitStatus.OPERATOR and operator and not _is_killed:
		_is_ended = true
	elif ExitStatus.PLANNED.has(status) and not _is_killed and _is_up(status, lived):
		_next_start = now
	else:
		_fail(now)


func is_running() -> bool:
	return _is_running


func has_beaten() -> bool:
	return _is_running and _has_beaten


## Seconds until the next start; 0 while it runs.
func get_wait(now: float) -> float:
	return 0.0 if _is_running else maxf(_next_start - now, 0.0)


# One that found no runtime has waited by itself.
func _is_up(status: int, lived: float) -> bool:
	return lived >= BRIEF_SECONDS or status == ExitStatus.RUNTIME_MISSING


func _fail(now: float) -> void:
	_next_start = now + minf(FIRST_WAIT * pow(2.0, failures), LONGEST_WAIT)
	failures += 1
