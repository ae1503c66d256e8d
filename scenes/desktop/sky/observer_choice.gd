# SPDX-License-Identifier: MIT
class_name ObserverChoice
extends Node
## Which observer sees the sky. What is impossible at the eye's place is refused by name; an
## observer who comes to where he cannot be turns into the nearest one who can.
##
## Places are from the hole, in Schwarzschild radii of its full mass.

## A wish that cannot be granted, or a change that nobody asked for.
signal warned(topic: StringName, text: String)

const TOPIC: StringName = &"observer"
## Those that a single key goes through.
const SIMPLE: Array[ObserverKind.Kind] = [
	ObserverKind.Kind.STATIC,
	ObserverKind.Kind.RAIN,
	ObserverKind.Kind.DROPPED,
	ObserverKind.Kind.ORBIT_RIGHT
]
const MOTIONS: Dictionary[ObserverKind.Kind, LensingTable.Motion] = {
	ObserverKind.Kind.STATIC: LensingTable.MOTION_STATIC,
	ObserverKind.Kind.RAIN: LensingTable.MOTION_RAIN,
	ObserverKind.Kind.DROPPED: LensingTable.MOTION_INFALL,
	ObserverKind.Kind.FALLING: LensingTable.MOTION_INFALL,
	ObserverKind.Kind.RISING: LensingTable.MOTION_INFALL,
	ObserverKind.Kind.ORBIT_RIGHT: LensingTable.MOTION_ORBIT,
	ObserverKind.Kind.ORBIT_LEFT: LensingTable.MOTION_ORBIT,
}
## The share of the hole's mass below which there is no hole.
const NO_HOLE: float = 1e-3
const LEAST_ENERGY: float = 0.3
const LARGEST_ENERGY: float = 3.0

@export var sky: BlackHoleSky:
	set(value):
		if sky != null:
			sky.observer_changed.disconnect(_follow)
		sky = value
		if sky != null:
			sky.observer_changed.connect(_follow)
			_follow()

## Energy per rest energy of who falls or rises with a chosen energy.
var energy: float = 1.2:
	set(value):
		energy = clampf(value, LEAST_ENERGY, LARGEST_ENERGY)

## During a ride its motion counts, not the choice.
var resting: bool = false:
	set(value):
		if value and not resting:
			_chosen = sky.observer
		resting = value

var _kind: ObserverKind.Kind = ObserverKind.Kind.STATIC
var _chosen: SkyObserver
var _resting_observer := SkyObserver.new()


## What is chosen: here, or by a motion that was set at the sky itself.
func get_kind() -> ObserverKind.Kind:
	return _kind


## Changes to `kind` at `place`, `up` being up in the picture; false, with a notice, where nobody
## can move so.
func choose(kind: ObserverKind.Kind, place: Vector3, up: Vector3) -> bool:
	var observer := make(kind, place, up)
	if not _exists(observer, place):
		var reason := ObserverKind.refusal(kind, _radius(place), energy)
		warned.emit(TOPIC, "%s %s" % [reason, tr("You stay as you are.")])
		return false
	_take(kind, observer)
	return true


## The next of the simple ones that exist at the place.
func choose_next(place: Vector3, up: Vector3) -> void:
	var current := SIMPLE.find(get_kind())
	for step in SIMPLE.size():
		var kind := SIMPLE[(current + 1 + step) % SIMPLE.size()]
		var observer := make(kind, place, up)
		if kind != get_kind() and _exists(observer, place):
			_take(kind, observer)
			return
	warned.emit(TOPIC, tr("Nothing can hover at or inside the horizon: you stay in free fall."))


## Turns who cannot be at `place` into who can.
func watch(place: Vector3) -> void:
	if resting:
		return
	var observer := sky.observer if sky.observer != null else _resting_observer
	if not _exists(observer, place):
		_fall_back(ObserverKind.refusal(get_kind(), _radius(place), observer.energy), place)


## Lets the choice count again after a ride that ended at `place`.
func resume(place: Vector3) -> void:
	resting = false
	var observer := _chosen if _chosen != null else make(_kind, place, Vector3.UP)
	_take(_kind, observer)
	watch(place)


## The observer of a kind at a place; null where nobody can even be thought to move so.
func make(kind: ObserverKind.Kind, place: Vector3, up: Vector3) -> SkyObserver:
	var observer := SkyObserver.new()
	observer.motion = MOTIONS[kind]
	match kind:
		ObserverKind.Kind.DROPPED:
			if _radius(place) <= 1.0:
				return null
			# A hair more, so that rounding does not put the place above the turning point.
			observer.energy = SkyObserver.energy_from_rest(_radius(place)) + 1e-7
		ObserverKind.Kind.FALLING, ObserverKind.Kind.RISING:
			observer.energy = energy
			observer.outgoing = kind == ObserverKind.Kind.RISING
		ObserverKind.Kind.ORBIT_RIGHT:
			observer.axis = up
		ObserverKind.Kind.ORBIT_LEFT:
			observer.axis = -up
	return observer


func _follow() -> void:
	if not resting and MOTIONS[_kind] != sky.observer_motion:
		var at := MOTIONS.values().find(sky.observer_motion)
		_kind = MOTIONS.keys()[at] if at >= 0 else ObserverKind.Kind.RAIN


# In Schwarzschild radii of the hole as it is now.
func _radius(place: Vector3) -> float:
	return place.length() / maxf(sky.lensing, NO_HOLE)


func _exists(observer: SkyObserver, place: Vector3) -> bool:
	if observer == null:
		return false
	return sky.lensing < NO_HOLE or observer.get_refusal(place / sky.lensing).is_empty()


func _fall_back(reason: String, place: Vector3) -> void:
	var falls := MOTIONS[_kind] == LensingTable.MOTION_INFALL
	var kind := (
		ObserverKind.Kind.STATIC if falls and _radius(place) > 1.0 else ObserverKind.Kind.RAIN
	)
	_take(kind, make(kind, place, Vector3.UP))
	var now := (
		tr("You hover now.") if kind == ObserverKind.Kind.STATIC else tr("You fall freely now.")
	)
	warned.emit(TOPIC, "%s %s" % [reason, now])


func _take(kind: ObserverKind.Kind, observer: SkyObserver) -> void:
	_kind = kind
	_chosen = observer
	sky.observer = observer
