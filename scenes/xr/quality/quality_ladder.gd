# SPDX-License-Identifier: MIT
class_name QualityLadder
extends Node
## Keeps the headset's pictures in time: when too many come late it draws less, rung by rung, and
## goes up again when there is time to spare. The top rung is what the visitor has chosen.
##
## A headset that misses a picture shows the last one a second time, turned to where the head now
## looks; more than a few of those in a row make people sick, a few stars less do not.

## Another rung: 0 is the top, the picture as chosen.
signal quality_changed(rung: int)

## A frame that took longer was no picture but a load, or a headset laid down, seconds.
const PAUSE_SECONDS: float = 0.9
## Frames after a step that say nothing about it, seconds: shaders are made ready.
const SETTLE_SECONDS: float = 0.2

@export var sky: BlackHoleSky
## May be empty.
@export var disk: AccretionDisk
## Whose pictures are counted while it is shown; empty: those of the program, always.
@export var session: XrSession
## Whose resolution is changed; empty: the session's.
@export var viewport: Viewport
## Off: the top rung, whatever it takes.
@export var enabled: bool = true:
	set = set_enabled
## From dear to cheap; empty: ready-made ones.
@export var rungs: Array[QualityRung] = []
## Pictures a second where the headset does not tell; 0: then it does nothing.
@export_range(0.0, 240.0, 1.0, "suffix:Hz") var fallback_rate: float = 72.0
## A picture is late when it takes longer than so many of the headset's.
@export_range(1.05, 2.0, 0.05) var late_from: float = 1.35
## With more late ones than this within a second it goes down.
@export_range(0.01, 0.5, 0.01) var most_late: float = 0.1
## And with fewer late ones than this it may go up,
@export_range(0.0, 0.1, 0.001) var few_late: float = 0.01
## when it has been so for this time.
@export_range(1.0, 60.0, 0.5, "suffix:s") var calm_seconds: float = 10.0
## A way up that leads down again within this time was none; the next try then waits twice as long,
@export_range(0.5, 10.0, 0.5, "suffix:s") var trial_seconds: float = 3.0
## up to this.
@export_range(10.0, 3600.0, 10.0, "suffix:s") var longest_wait: float = 300.0

var _choice := PictureChoice.new()
var _rung: int = 0
var _window := FrameWindow.new()
var _last_usec: int = 0
var _settling: float = SETTLE_SECONDS
# Since the last step, or since there were too many late ones for going up.
var _calm: float = 0.0
var _calm_frames: int = 0
var _calm_late: int = 0
var _wait: float = 0.0
# Since the last step up; negative: none is being tried.
var _tried: float = -1.0


func _ready() -> void:
	if rungs.is_empty():
		rungs = standard_rungs()
	_choice.sky = sky
	_choice.disk = disk
	_choice.viewport = viewport
	if viewport == null and session != null:
		_choice.viewport = session.viewport
	_wait = calm_seconds
	_choice.note()


func _process(_delta: float) -> void:
	var now := Time.get_ticks_usec()
	var frame := (now - _last_usec) * 1e-6
	var first := _last_usec == 0
	_last_usec = now
	if session != null and not session.is_shown():
		_last_usec = 0
		_begin_anew()
	elif not first:
		see_frame(frame)


## What a computer's graphics card is asked for, from dear to cheap.
static func standard_rungs() -> Array[QualityRung]:
	return [
		QualityRung.make(2, 9.0, false, 3, 1.0),
		QualityRung.make(2, 7.5, true, 2, 0.9),
		QualityRung.make(2, 6.5, true, 2, 0.75),
		QualityRung.make(1, 6.0, true, 1, 0.6),
	]


## Takes note of a frame that took so long, in seconds.
func see_frame(seconds: float) -> void:
	var period := get_period()
	if not enabled or period <= 0.0:
		return
	if seconds >= PAUSE_SECONDS:
		_begin_anew()
		return
	if _settling > 0.0:
		_settling -= seconds
		return
	var is_late := seconds > late_from * period
	_window.add(seconds, is_late)
	_calm += seconds
	_calm_frames += 1
	_calm_late += 1 if is_late else 0
	if _tried >= 0.0:
		_tried += seconds
		if _tried > calm_seconds:
			_tried = -1.0
			_wait = calm_seconds
	if _window.is_full() and _window.get_late_share() > most_late:
		_go_down()
	elif _calm >= _wait:
		_go_up()


## How long a picture of the headset takes, seconds; 0: unknown.
func get_period() -> float:
	var rate := 0.0
	if session != null and session.get_interface() != null:
		rate = session.get_interface().display_refresh_rate
	rate = rate if rate > 0.0 else fallback_rate
	return 1.0 / rate if rate > 0.0 else 0.0


## The present rung, 0 at the top.
func get_rung() -> int:
	return _rung


## The cheapest rung.
func get_lowest_rung() -> int:
	return rungs.size()


## Steps onto a rung, 0 to get_lowest_rung().
func step_to(rung: int) -> void:
	rung = clampi(rung, 0, rungs.size())
	_begin_anew()
	_settling = SETTLE_SECONDS
	if rung == _rung:
		return
	_rung = rung
	_choice.apply(null if rung == 0 else rungs[rung - 1])
	quality_changed.emit(rung)


func set_enabled(value: bool) -> void:
	if value == enabled:
		return
	enabled = value
	if is_node_ready():
		step_to(0)
		_tried = -1.0
		_wait = calm_seconds
		_choice.note()


func _go_down() -> void:
	if _rung == rungs.size():
		_begin_anew()
		return
	if _tried >= 0.0 and _tried <= trial_seconds:
		_wait = minf(2.0 * _wait, longest_wait)
	_tried = -1.0
	step_to(_rung + 1)


func _go_up() -> void:
	var calm := _calm_late < few_late * _calm_frames
	if _rung == 0 or not calm:
		_begin_calm()
		return
	step_to(_rung - 1)
	_tried = 0.0


func _begin_anew() -> void:
	_window.clear()
	_begin_calm()


func _begin_calm() -> void:
	_calm = 0.0
	_calm_frames = 0
	_calm_late = 0
