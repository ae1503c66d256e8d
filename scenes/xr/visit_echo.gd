# SPDX-License-Identifier: MIT
class_name VisitEcho
extends Node
## Lets what happens in a visit be heard by the visitor and read by those who stand around.

@export var pointer: XrPointer
@export var rig: XrRig
@export var rides: XrRides
@export var cards: HoleCards
@export var near_limit: NearLimit
@export var sounds: VisitSounds
@export var spectator: Spectator


func _ready() -> void:
	pointer.pointed_at.connect(_on_pointed_at)
	pointer.chosen.connect(_on_chosen)
	rig.jumped.connect(_on_jumped)
	cards.opened.connect(_on_card_opened)
	near_limit.crossed.connect(_on_too_near)
	rides.counted_down.connect(_on_counted_down)
	rides.began.connect(_caption)
	rides.ended.connect(_on_ride_ended)
	rides.pause_changed.connect(_on_pause_changed)
	_caption()


func _notification(what: int) -> void:
	if what == NOTIFICATION_TRANSLATION_CHANGED and is_node_ready():
		_caption()


## What the visitor is doing, for those who stand around.
func caption() -> String:
	if rides.is_paused():
		return tr("The visitor has stopped time.")
	match rides.state:
		XrRides.State.COUNTDOWN, XrRides.State.BEGINNING:
			return tr("The visitor is about to set off.")
		XrRides.State.RIDING when rides.ride is FallRide:
			return tr("The visitor falls into a black hole.")
		XrRides.State.RIDING:
			return tr("The visitor flies round a black hole in free fall.")
	return tr("A visitor walks round a black hole.")


func _caption() -> void:
	spectator.set_caption(caption())


func _on_pointed_at(target: PointTarget) -> void:
	if target != null:
		sounds.play(VisitSounds.HOVER)


func _on_chosen(_target: PointTarget) -> void:
	sounds.play(VisitSounds.CHOOSE)


func _on_jumped() -> void:
	if rig.is_blinking():
		sounds.play(VisitSounds.BLINK)


func _on_card_opened(_index: int) -> void:
	sounds.play(VisitSounds.CARD)


func _on_too_near(too_near: bool) -> void:
	if too_near:
		sounds.play(VisitSounds.WARNING)


func _on_counted_down(_seconds: int) -> void:
	sounds.play(VisitSounds.HOVER)
	_caption()


func _on_ride_ended(_completed: bool) -> void:
	_caption()


func _on_pause_changed(_paused: bool) -> void:
	_caption()
