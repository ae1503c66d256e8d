# SPDX-License-Identifier: MIT
class_name XrSession
extends Node
## The one owner of the OpenXR session: starts it, follows its states and notices a runtime that
## died.
##
## Nothing here ends the program: without a runtime the scene goes on at the screen, and whoever
## takes the headset off finds everything as it was left.

## The headset shows the scene, for the first time or after it had been taken off.
signal started
## There is no session and there will be none by itself: `reason` for people.
signal unavailable(reason: String)
## The visitor is there and nothing of the runtime's own lies over the scene, or no longer so.
signal focus_changed(focused: bool)
## The runtime has died. The engine keeps its connection to it for life, so that only a new start of
## the program leads to another one.
signal lost
## The visitor asked the headset's own menu to put the view straight.
signal recentred

enum State { NONE, OPENING, SHOWN, FOCUSED, LOST }

const INTERFACE: StringName = &"OpenXR"
## Physics ticks where the headset does not say how often it shows a picture, per second.
const USUAL_RATE: int = 90

## What the headset shows. Not the window's own viewport: that keeps the headset's pictures as its
## render target when the session ends.
@export var viewport: SubViewport
## How often a second the headset shall show a picture; 0: as it likes.
@export var wanted_refresh_rate: float = 0.0
## Shading rate of the outer parts of the picture: the renderer's own, or the headset's foveation.
@export var foveated: bool = true

var state := State.NONE

var _interface: OpenXRInterface
var _watch := RuntimeWatch.new()
var _errors := RuntimeErrors.new()
var _screen_vsync := DisplayServer.VSYNC_ENABLED


func _ready() -> void:
	process_mode = Node.PROCESS_MODE_ALWAYS
	OS.add_logger(_errors)


func _exit_tree() -> void:
	OS.remove_logger(_errors)
	_leave_viewport()
	_disconnect()


func _process(_delta: float) -> void:
	match state:
		State.SHOWN, State.FOCUSED:
			_watch.see_frame(
				Time.get_ticks_usec(), get_head_pose(), _interface.display_refresh_rate
			)
			if _errors.has_seen_loss() or _watch.is_dead():
				_on_lost()
		State.OPENING:
			# A runtime may die before it has shown anything.
			if _errors.has_seen_loss():
				_on_lost()
			else:
				_see_state()


## Opens a session. False: there is none, and `unavailable` has said why.
func start() -> bool:
	var found := XRServer.find_interface(INTERFACE)
	if not found is OpenXRInterface:
		_refuse(tr("This build of the engine has no OpenXR."))
		return false
	_interface = found
	if not _interface.is_initialized() and not _interface.initialize():
		_refuse(
			tr("No headset: no OpenXR runtime answers. Start it, put the headset on, start again.")
		)
		return false
	_connect()
	_enter_viewport()
	return true


func has_focus() -> bool:
	return state == State.FOCUSED


## Is there a picture in the headset?
func is_shown() -> bool:
	return state == State.SHOWN or state == State.FOCUSED


## Where the head is in the room, metres.
func get_head_pose() -> Transform3D:
	var head := XRServer.get_tracker(&"head") as XRPositionalTracker
	var pose := head.get_pose(&"default") if head != null else null
	return pose.transform if pose != null and pose.has_tracking_data else Transform3D.IDENTITY


## The corners of the floor on which one may walk, metres; none: one stands or sits.
func get_play_area() -> PackedVector3Array:
	if _interface.get_play_area_mode() < XRInterface.XR_PLAY_AREA_ROOMSCALE:
		return []
	return _interface.get_play_area()


## The interface to the headset; null before start().
func get_interface() -> OpenXRInterface:
	return _interface


func _refuse(reason: String) -> void:
	state = State.NONE
	unavailable.emit(reason)


func _enter_viewport() -> void:
	state = State.OPENING
	viewport.use_xr = true
	viewport.render_target_update_mode = SubViewport.UPDATE_ALWAYS
	if foveated:
		viewport.vrs_mode = Viewport.VRS_XR
		_interface.foveation_level = 3
		_interface.foveation_dynamic = true
	_screen_vsync = DisplayServer.window_get_vsync_mode()
	# The headset sets the pace, not the screen.
	DisplayServer.window_set_vsync_mode(DisplayServer.VSYNC_DISABLED)


func _leave_viewport() -> void:
	if _interface == null or state == State.NONE or viewport == null:
		return
	viewport.render_target_update_mode = SubViewport.UPDATE_DISABLED
	viewport.use_xr = false
	DisplayServer.window_set_vsync_mode(_screen_vsync)


# Which of our methods hears which signal of the interface.
func _ears() -> Dictionary[Signal, Callable]:
	return {
		_interface.session_begun: _on_session_begun,
		_interface.session_visible: _on_session_visible,
		_interface.session_focussed: _on_session_focused,
		_interface.session_stopping: _on_session_stopping,
		_interface.session_loss_pending: _on_loss_pending,
		_interface.instance_exiting: _on_loss_pending,
		_interface.pose_recentered: recentred.emit,
		_interface.refresh_rate_changed: _on_refresh_rate_changed,
	}


func _connect() -> void:
	var ears := _ears()
	for said: Signal in ears:
		said.connect(ears[said])


func _disconnect() -> void:
	if _interface == null or not _interface.session_begun.is_connected(_on_session_begun):
		return
	var ears := _ears()
	for said: Signal in ears:
		said.disconnect(ears[said])


func _on_session_begun() -> void:
	var rate := wanted_refresh_rate
	var offered := _interface.get_available_display_refresh_rates()
	if rate > 0.0 and not offered.is_empty():
		var nearest: float = offered[0]
		for one: float in offered:
			nearest = one if absf(one - rate) < absf(nearest - rate) else nearest
		_interface.display_refresh_rate = nearest
	_on_refresh_rate_changed(_interface.display_refresh_rate)


# Physics that ticks at another pace than the picture would stutter.
func _on_refresh_rate_changed(rate: float) -> void:
	Engine.physics_ticks_per_second = roundi(rate) if rate > 0.0 else USUAL_RATE


func _on_session_visible() -> void:
	var first := state == State.OPENING
	var had_focus := state == State.FOCUSED
	state = State.SHOWN
	_watch.reset()
	if first:
		started.emit()
	if had_focus:
		focus_changed.emit(false)


func _on_session_focused() -> void:
	if state == State.OPENING:
		_on_session_visible()
	state = State.FOCUSED
	focus_changed.emit(true)


# On some headsets this comes each time they are taken off; the session begins again by itself.
func _on_session_stopping() -> void:
	if state == State.FOCUSED:
		focus_changed.emit(false)
	if is_shown():
		state = State.OPENING


func _on_loss_pending() -> void:
	if is_shown() or state == State.OPENING:
		_on_lost()


func _on_lost() -> void:
	var had_focus := state == State.FOCUSED
	_leave_viewport()
	_disconnect()
	state = State.LOST
	_interface.uninitialize()
	if had_focus:
		focus_changed.emit(false)
	lost.emit()


# A session that was there before this node sends no signal about it.
func _see_state() -> void:
	match _interface.get_session_state():
		OpenXRInterface.SESSION_STATE_VISIBLE:
			_on_session_visible()
		OpenXRInterface.SESSION_STATE_FOCUSED:
			_on_session_focused()
