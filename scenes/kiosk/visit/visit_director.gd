# SPDX-License-Identifier: MIT
class_name VisitDirector
extends RefCounted
## What becomes of a visitor: called, asked for the language, told of risks, shown round, thanked.
## It knows no scene; time and what visitors do are passed in.

signal state_changed(state: State)
## A visitor has come; `by` what they did.
signal visit_begun(by: StringName)
## The visitor has gone, or has to go; one of the ways below.
signal visit_ended(how: StringName)
## So many seconds are left.
signal end_announced(seconds: float)

enum State { ATTRACT, LANGUAGE, HEALTH, CHOICE, VISIT, ENDING }

## How a visit ends.
const TIME: StringName = &"time"
const IDLE: StringName = &"idle"
const HEADSET_OFF: StringName = &"headset_off"
const FINISHED: StringName = &"finished"
const DECLINED: StringName = &"declined"
const OPERATOR: StringName = &"operator"
const LOST: StringName = &"lost"
## Whom nobody thanks: there is nobody.
const SUDDEN: Array[StringName] = [IDLE, HEADSET_OFF, DECLINED, OPERATOR, LOST]
## What a visit can be.
const TOUR: StringName = &"tour"
const FLIGHT: StringName = &"flight"
## Names for logs.
const NAMES: Dictionary[State, String] = {
	State.ATTRACT: "attract",
	State.LANGUAGE: "language",
	State.HEALTH: "health",
	State.CHOICE: "choice",
	State.VISIT: "visit",
	State.ENDING: "ending",
}

var idle_seconds: float = 90.0
var off_seconds: float = 15.0
## Longest visit; 0: no limit.
var visit_seconds: float = 720.0
## So long before its end it is announced.
var notice_seconds: float = 45.0
## So long the visitor is thanked.
var ending_seconds: float = 10.0
var asks_language: bool = true
var asks_health: bool = true
## More than one: the visitor chooses.
var contents: Array[StringName] = [TOUR, FLIGHT]
## Whether visitors wear a headset; then only one that is off, or time, ends a visit by itself.
var with_headset: bool = false
## While false nobody can begin: the exhibit is being made ready.
var is_ready: bool = true

var state: State = State.ATTRACT
## How far the visitor has come.
var reached: State = State.ATTRACT
## What the visitor chose.
var content: StringName = &""

var _is_worn: bool = false
var _idle: float = 0.0
var _off: float = 0.0
var _clock: float = 0.0
var _thanking: float = 0.0
var _announced: bool = false


## Takes the settings over that concern visits.
func configure(config: KioskConfig, headset: bool) -> void:
	with_headset = headset
	idle_seconds = config.number("idle_seconds")
	off_seconds = config.number("headset_off_seconds")
	visit_seconds = 60.0 * config.number("visit_minutes")
	notice_seconds = config.number("soft_end_seconds")
	asks_language = config.list("languages").size() > 1
	var health := config.text("health_notice")
	asks_health = health == "always" or (health == "headset" and headset)
	match config.text("content"):
		"tour":
			contents = [TOUR]
		"flight":
			contents = [FLIGHT]


func is_visiting() -> bool:
	return state != State.ATTRACT and state != State.ENDING


## Somebody wants to begin. False: not now.
func wake(by: StringName) -> bool:
	if state != State.ATTRACT or not is_ready:
		return false
	_idle = 0.0
	_off = 0.0
	_clock = 0.0
	_announced = false
	content = &""
	reached = State.ATTRACT
	visit_begun.emit(by)
	_go_on(State.LANGUAGE)
	return true


## A sign of life.
func touch() -> void:
	_idle = 0.0


## The headset sits on a head, or no longer.
func set_worn(worn: bool) -> void:
	_is_worn = worn
	_off = 0.0


## The language is chosen.
func take_language() -> void:
	if state == State.LANGUAGE:
		touch()
		_go_on(State.HEALTH)


func accept_health() -> void:
	if state == State.HEALTH:
		touch()
		_go_on(State.CHOICE)


## What the visit shall be is chosen.
func choose(chosen: StringName) -> void:
	if state == State.CHOICE:
		touch()
		content = chosen
		_go_on(State.VISIT)


## One step back; from the first one the visitor goes.
func step_back() -> void:
	touch()
	match state:
		State.CHOICE:
			_go_to(State.HEALTH if asks_health else State.LANGUAGE if asks_language else state)
		State.HEALTH:
			if asks_language:
				_go_to(State.LANGUAGE)
			else:
				end(DECLINED)
		State.LANGUAGE:
			end(DECLINED)


## Ends the visit, if one is on.
func end(how: StringName) -> void:
	if not is_visiting():
		return
	visit_ended.emit(how)
	_thanking = 0.0
	_go_to(State.ATTRACT if how in SUDDEN else State.ENDING)


## Seconds until the visit ends; INF: no limit, or none is on.
func get_seconds_left() -> float:
	if state != State.VISIT or visit_seconds <= 0.0:
		return INF
	return maxf(visit_seconds - _clock, 0.0)


## Lets time pass.
func advance(seconds: float) -> void:
	if state == State.ENDING:
		_thanking += seconds
		if _thanking >= ending_seconds:
			_go_to(State.ATTRACT)
		return
	if state == State.ATTRACT:
		return
	# Who wears the headset and watches is there, though no key is pressed.
	_idle = 0.0 if with_headset and _is_worn else _idle + seconds
	_off += seconds
	if with_headset and not _is_worn and _off >= off_seconds:
		end(HEADSET_OFF)
	elif _idle >= idle_seconds:
		end(IDLE)
	elif state == State.VISIT:
		_run_clock(seconds)


func _run_clock(seconds: float) -> void:
	_clock += seconds
	var left := get_seconds_left()
	if left <= 0.0:
		end(TIME)
	elif left <= notice_seconds and not _announced:
		_announced = true
		end_announced.emit(left)


# To a step, or past those that have nothing to ask.
func _go_on(to: State) -> void:
	if to == State.LANGUAGE and not asks_language:
		to = State.HEALTH
	if to == State.HEALTH and not asks_health:
		to = State.CHOICE
	if to == State.CHOICE and contents.size() == 1:
		content = contents[0]
		to = State.VISIT
	_go_to(to)


func _go_to(to: State) -> void:
	if to == state:
		return
	state = to
	if is_visiting():
		reached = maxi(reached, state) as State
	state_changed.emit(state)
