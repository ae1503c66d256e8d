# SPDX-License-Identifier: MIT
class_name Kiosk
extends Node
## The exhibit: calls visitors, shows them round, thanks them, and is as new for the next one. Joins
## the parts.

## Seconds of the veil while the scene is made anew.
const VEIL_SECONDS: float = 0.7
## So long the window tells that the headset is gone, or not there, before the program starts again.
const LOST_SECONDS: float = 1.5
const MISSING_SECONDS: float = 4.0
## A computer that slept has not been visited meanwhile.
const LONGEST_STEP: float = 2.0
## Between two looks whether the program is to end, seconds.
const LOOK_SECONDS: float = 5.0

## The settings; those of the program unless others are given before it enters the tree.
var config: KioskConfig
var director := VisitDirector.new()

var _recorder: VisitRecorder
var _facts := OperatorFacts.new()
var _board: KioskBoard
var _veiling: Tween
var _since_look: float = 0.0
var _last_usec: int = Time.get_ticks_usec()
var _started: float = DailyRestart.local_now()
var _leaving: String = ""

@onready var _window: ExhibitWindow = $Window
@onready var _notes: KioskNotes = $Notes
@onready var _content: ExhibitContent = $Content
@onready var _ride: AttractRide = $Ride
@onready var _screens: KioskScreens = %Screens
@onready var _clock: VisitClock = %Clock
@onready var _veil: ColorRect = %Veil
@onready var _waiting: CanvasItem = %Waiting
@onready var _desk: OperatorDesk = $Desk
@onready var _presence: VisitorPresence = $Presence
@onready var _call: OperatorCall = $Call


func _enter_tree() -> void:
	KioskMode.set_on(true)


func _exit_tree() -> void:
	KioskMode.set_on(false)


func _ready() -> void:
	if config == null:
		config = KioskConfig.of_program()
	_notes.words = _words
	_notes.open(config)
	_recorder = VisitRecorder.new(_notes.visits)
	var headset := _is_headset_wanted()
	director.configure(config, headset)
	director.is_ready = false
	_connect_parts()
	_window.configure(config)
	_call.set_hotkey(config.text("operator_hotkey"))
	_screens.configure(config, headset)
	_content.tour_file = config.text("tour")
	_prepare_desk()
	if headset and not _is_runtime_there():
		_wait_for_runtime()
	elif _content.prepare(headset):
		_content.renew()
	else:
		push_error("The exhibit's scene cannot be loaded. Install the program anew.")
		leave(ExitStatus.INCOMPLETE, "incomplete")


# By the clock: the engine's own time runs slower where pictures take long.
func _process(_delta: float) -> void:
	var now := Time.get_ticks_usec()
	var delta := minf((now - _last_usec) * 1e-6, LONGEST_STEP)
	_last_usec = now
	var seconds := delta * TimeScale.of_program()
	director.advance(seconds)
	if director.is_visiting():
		_recorder.pass_time(seconds)
	if director.state == VisitDirector.State.VISIT:
		_watch_visit(delta)
	_since_look += delta
	if director.state == VisitDirector.State.ATTRACT and _since_look >= LOOK_SECONDS:
		_since_look = 0.0
		_leave_if_due()


## Ends the program with a status, leaving word why.
func leave(status: int, why: String) -> void:
	if not _leaving.is_empty():
		return
	director.end(VisitDirector.OPERATOR)
	_leaving = why
	_notes.note("leaving: " + why)
	_notes.close()
	get_tree().quit(status)


func _connect_parts() -> void:
	director.state_changed.connect(_on_state_changed)
	director.visit_begun.connect(_on_visit_begun)
	director.visit_ended.connect(_on_visit_ended)
	_content.renewed.connect(_on_renewed)
	_content.lost.connect(_on_lost)
	_content.finished.connect(director.end.bind(VisitDirector.FINISHED))
	_content.station_begun.connect(_recorder.see_station)
	_content.reset_seen.connect(_recorder.see_reset)
	_presence.touched.connect(director.touch)
	_presence.pressed.connect(_wake.bind(&"button"))
	_presence.worn_changed.connect(_on_worn_changed)
	_listen_to(_screens)
	_call.asked.connect(_desk.call_up)
	_desk.busy_changed.connect(_share_input)
	_desk.noted.connect(_notes.note)
	_desk.reset_asked.connect(_on_reset_asked)
	_desk.leave_asked.connect(leave)


func _listen_to(screens: KioskScreens) -> void:
	screens.start_asked.connect(_wake.bind(&"gaze"))
	screens.language_chosen.connect(_on_language_chosen)
	screens.health_accepted.connect(director.accept_health)
	screens.content_chosen.connect(director.choose)
	screens.back_asked.connect(director.step_back)


func _prepare_desk() -> void:
	_facts.config = config
	_facts.content = _content
	_facts.director = director
	_facts.recorder = _recorder
	_facts.notes = _notes
	_desk.config = config
	_desk.content = _content
	_desk.recorder = _recorder
	_desk.prepare(_facts.tell, _notes.errors.get_texts)


# The scene is new: all that a visitor may have changed is as at the beginning.
func _on_renewed() -> void:
	_window.configure(config)
	_window.forbid_leaving()
	TranslationServer.set_locale(config.text("language"))
	_desk.take_volume(config.number("volume"))
	_ride.sky = _content.get_sky()
	_presence.watch(_content.get_session())
	_board = _content.put_up_board(config)
	if _board != null:
		_listen_to(_board.screens)
	director.is_ready = true
	_show_state()
	_fade_veil(0.0)
	_notes.note("ready")


func _on_state_changed(state: VisitDirector.State) -> void:
	_notes.note("state " + VisitDirector.NAMES[state])
	if state == VisitDirector.State.ATTRACT:
		_renew_behind_veil()
		return
	_show_state()
	if state == VisitDirector.State.VISIT:
		_content.begin(director.content)
	elif state == VisitDirector.State.ENDING:
		_content.end()


# Who sees what: the window's pages are over the attract ride; in the headset they are on the board,
# and the window then shows the visitor's view.
func _show_state() -> void:
	var state := director.state
	var calling := state == VisitDirector.State.ATTRACT
	var behind := calling or (state != VisitDirector.State.VISIT and not director.with_headset)
	_ride.run(behind)
	_content.show_to_visitor(not behind)
	_screens.show_state(state if behind else VisitDirector.State.VISIT)
	if _board != null:
		_board.show_state(state, _content.get_head())
	_clock.show_left(INF)
	_share_input()


func _renew_behind_veil() -> void:
	director.is_ready = false
	_screens.show_state(VisitDirector.State.VISIT)
	_clock.show_left(INF)
	_fade_veil(1.0)
	await _veiling.finished
	_board = null
	_content.renew()


func _fade_veil(to: float) -> void:
	if _veiling != null:
		_veiling.kill()
	_veil.show()
	_veiling = create_tween()
	_veiling.tween_property(_veil, "modulate:a", to, VEIL_SECONDS)
	if to == 0.0:
		_veiling.tween_callback(_veil.hide)


func _on_visit_begun(by: StringName) -> void:
	var number := _recorder.begin("headset" if director.with_headset else "screen")
	_notes.note("visit %d begins: %s" % [number, by])


func _on_visit_ended(how: StringName) -> void:
	_notes.note("visit ends: " + _recorder.finish(director, how))


func _watch_visit(delta: float) -> void:
	_recorder.see_picture(delta, _content.get_picture_period())
	var left := director.get_seconds_left()
	_clock.show_left(left if left <= director.notice_seconds else INF)
	if not director.with_headset and Input.is_action_just_pressed(&"reset_view"):
		_recorder.see_reset()


func _wake(by: StringName) -> void:
	if config.list("start_by").has(by) and not _desk.is_busy():
		director.wake(by)


func _on_worn_changed(worn: bool) -> void:
	director.set_worn(worn)
	if worn and _board != null:
		_board.come_to(_content.get_head())
		_wake(&"headset")


func _on_language_chosen(locale: String) -> void:
	TranslationServer.set_locale(locale)
	director.take_language()


# Keys are the visitor's on the way, the exhibit's while it calls, the operator's before all.
func _share_input() -> void:
	_presence.swallows = director.state == VisitDirector.State.ATTRACT and not _desk.is_busy()
	_content.hold(_desk.is_busy() or director.state != VisitDirector.State.VISIT)


func _on_reset_asked() -> void:
	if director.is_visiting():
		director.end(VisitDirector.OPERATOR)
	elif director.state == VisitDirector.State.ATTRACT and director.is_ready:
		_renew_behind_veil()


func _is_headset_wanted() -> bool:
	match config.text("mode"):
		"headset":
			return true
		"screen":
			return false
	return _is_runtime_there() or Supervision.is_started_again()


func _is_runtime_there() -> bool:
	var interface := XRServer.find_interface(XrSession.INTERFACE)
	return interface != null and interface.is_initialized()


func _wait_for_runtime() -> void:
	push_warning("The headset's runtime does not answer. Start it and connect the headset.")
	_tell_missing(MISSING_SECONDS, ExitStatus.RUNTIME_MISSING, "runtime missing")


func _on_lost() -> void:
	director.end(VisitDirector.LOST)
	_tell_missing(LOST_SECONDS, ExitStatus.RUNTIME_LOST, "runtime lost")


# The engine finds a runtime only when it starts.
func _tell_missing(seconds: float, status: int, why: String) -> void:
	_waiting.show()
	if Supervision.is_supervised():
		await get_tree().create_timer(seconds).timeout
		leave(status, why)


# While nobody is there.
func _leave_if_due() -> void:
	if SupervisorWatch.is_gone(CommandLine.of_program()):
		leave(ExitStatus.ORPHANED, "supervisor gone")
	elif DailyRestart.is_due(
		config.whole("daily_restart_hour"), _started, DailyRestart.local_now()
	):
		leave(ExitStatus.DAILY, "daily restart")


# What the sign of life says of a visit.
func _words() -> Dictionary:
	return {
		"step": VisitDirector.NAMES[director.state],
		"visit": _notes.visits.get_last_number(),
		"last_visit": _recorder.last_line if _recorder != null else "",
		"ready": director.is_ready,
		"nodes": roundi(Performance.get_monitor(Performance.OBJECT_NODE_COUNT)),
		"leaving": _leaving,
	}
