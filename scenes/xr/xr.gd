# SPDX-License-Identifier: MIT
class_name XrScene
extends Node3D
## The hole as a thing in the visitor's room, seen with a headset; without one the desktop scene.

const DESKTOP_SCENE: String = "res://scenes/desktop/desktop.tscn"
## So long the screen says that the headset is gone before the program starts again, seconds.
const NOTICE_SECONDS: float = 1.5
## And between two looks whether it is back.
const LOOK_SECONDS: float = 4.0

var _is_placed: bool = false

@onready var session: XrSession = $Session
@onready var sky: BlackHoleSky = $Sky
@onready var hole: HoleInRoom = $Hole
@onready var head: XRCamera3D = $Headset/Origin/Head
@onready var _data: SkyData = $Data
@onready var _screen: ScreenNotice = $Screen


func _ready() -> void:
	session.unavailable.connect(_on_unavailable)
	session.lost.connect(_on_lost)
	session.recentred.connect(_put_hole)
	session.focus_changed.connect(_on_focus_changed)
	_data.load_all()
	session.start()


func _process(_delta: float) -> void:
	# The head's place is known some frames after the first picture.
	if not _is_placed and session.is_shown() and session.get_head_pose() != Transform3D.IDENTITY:
		_put_hole()


## Has the runtime gone, so that the screen asks for patience?
func is_waiting_for_headset() -> bool:
	return _screen.visible


## Puts the hole anew before the visitor.
func _put_hole() -> void:
	_is_placed = true
	hole.place(session.get_play_area(), session.get_head_pose())


func _on_unavailable(reason: String) -> void:
	if Supervision.is_supervised() and Supervision.is_started_again():
		_wait_for_headset(Supervision.STILL_WAITING, LOOK_SECONDS)
		return
	push_warning("XR: %s The desktop scene is shown instead." % reason)
	get_tree().change_scene_to_file.call_deferred(DESKTOP_SCENE)


func _on_lost() -> void:
	_wait_for_headset(Supervision.LOST, NOTICE_SECONDS)


func _on_focus_changed(focused: bool) -> void:
	print("xr: %s" % ("in focus" if focused else "out of focus"))


func _wait_for_headset(status: int, seconds: float) -> void:
	if not Supervision.is_supervised():
		_screen.show_text(tr("The headset is not connected. Start the program again to find it."))
		return
	_screen.show_text(tr("The headset is not connected. The exhibit goes on when it is back."))
	await get_tree().create_timer(seconds).timeout
	# Tests have the scene in a tree that is not its own.
	if get_tree().current_scene == self:
		get_tree().quit(status)
