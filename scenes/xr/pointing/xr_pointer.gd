# SPDX-License-Identifier: MIT
class_name XrPointer
extends Node3D
## Points at things and chooses them: with the hand that was used last, or by looking. Where no hand
## is in use, what the gaze rests on for a while is chosen.
##
## Things to point at are the nodes PointTarget in the same tree that are visible.

## The ray rests on something else; null: on nothing.
signal pointed_at(target: PointTarget)
## Something has been chosen.
signal chosen(target: PointTarget)

## Seconds between two looks for new things to point at.
const LOOK_SECONDS: float = 0.25
## Another hand that moves takes over when this one has been still for so long, seconds.
const TAKE_OVER_SECONDS: float = 0.5
const HOVER_PULSE: float = 0.2
const CHOICE_PULSE: float = 0.5

@export var head: Node3D
@export var hands: Array[XrHand] = []
## Says which hands count; empty: all.
@export var comfort: Comfort
## A hand that has not been used for so long leaves pointing to the gaze.
@export_range(0.0, 60.0, 0.5, "suffix:s") var rest_seconds: float = 5.0
## Switched off it points at nothing and shows nothing.
@export var enabled: bool = true

var _uses: Array[HandUse] = []
## The things to point at, by number: they may go at any time.
var _targets: PackedInt64Array = []
var _since_look: float = INF
## The one that points; null: the gaze.
var _pointing: HandUse
## By number as well; 0: nothing.
var _target: int = 0
var _what: Variant
var _held: PointTarget
var _dwelt: float = 0.0
## What is looked at has been chosen already.
var _is_spent: bool = false
var _from := Vector3.ZERO
var _direction := Vector3.FORWARD
var _distance: float = INF
var _marks := PointerMarks.new()


func _ready() -> void:
	add_child(_marks)
	for hand in hands:
		var use := HandUse.new(hand)
		_uses.append(use)
		hand.chosen.connect(_on_chosen.bind(use))
		hand.let_go.connect(_let_go)


func _exit_tree() -> void:
	_let_go()
	_point_at(null)


func _process(delta: float) -> void:
	advance(delta)


## Looks where everything points, `delta` seconds after the last time.
func advance(delta: float) -> void:
	_since_look += delta
	if _since_look >= LOOK_SECONDS:
		_find_targets()
	for use in _uses:
		use.watch(delta)
	_change_hand()
	_cast()
	if is_by_gaze():
		_dwell(delta)
	_show()


## Does the gaze point, because no hand does?
func is_by_gaze() -> bool:
	return _pointing == null


## What is pointed at; null: nothing.
func get_target() -> PointTarget:
	return instance_from_id(_target) as PointTarget if _target != 0 else null


## How much of the wait is over after which the gaze chooses, 0 to 1.
func get_dwell() -> float:
	var target := get_target()
	if target == null or _is_spent or not is_by_gaze() or _what == null:
		return 0.0
	return clampf(_dwelt / maxf(target.dwell_seconds(), 1e-3), 0.0, 1.0)


func _find_targets() -> void:
	_since_look = 0.0
	_targets.clear()
	for node in get_tree().get_nodes_in_group(PointTarget.GROUP):
		if node is PointTarget:
			_targets.append(node.get_instance_id())


func _counts(use: HandUse) -> bool:
	if not use.hand.is_here():
		return false
	return comfort == null or comfort.counts(use.hand.tracker == &"left_hand")


func _change_hand() -> void:
	var present := _pointing
	if present != null and (not _counts(present) or present.unused > rest_seconds):
		present = null
	for use in _uses:
		if use == present or not _counts(use) or use.unused > rest_seconds:
			continue
		var is_still := present == null or present.unused > TAKE_OVER_SECONDS
		if is_still and (present == null or use.unused < present.unused):
			present = use
	_point_with(present)


func _point_with(use: HandUse) -> void:
	if use == _pointing:
		return
	_let_go()
	_pointing = use
	_dwelt = 0.0
	_is_spent = false


# The nearest thing on the ray.
func _cast() -> void:
	if is_by_gaze():
		_from = head.global_position
		_direction = -head.global_basis.z.normalized()
	else:
		_from = _pointing.hand.global_position
		_direction = _pointing.hand.get_direction()
	_distance = INF
	var nearest: PointTarget = null
	if enabled:
		for id in _targets:
			var target := instance_from_id(id) as PointTarget
			if target == null or not target.is_visible_in_tree():
				continue
			var distance := target.distance_along(_from, _direction)
			if distance < _distance:
				_distance = distance
				nearest = target
	_point_at(nearest)


func _point_at(target: PointTarget) -> void:
	var id := target.get_instance_id() if target != null else 0
	if id != _target:
		if get_target() != null:
			get_target().leave()
		_target = id
		_see(null)
		pointed_at.emit(target)
	if target != null:
		target.point_at(_from + _direction * _distance)
		_see(target.what_is_pointed_at())


# Another part than before begins a new wait.
func _see(what: Variant) -> void:
	if is_same(what, _what):
		return
	_what = what
	_dwelt = 0.0
	_is_spent = false
	if what != null and not is_by_gaze():
		_pointing.hand.pulse(HOVER_PULSE)


func _dwell(delta: float) -> void:
	var target := get_target()
	if target == null or _what == null or _is_spent:
		return
	_dwelt += delta
	if _dwelt >= target.dwell_seconds():
		_is_spent = true
		_choose()
		_let_go()


func _choose() -> bool:
	var target := get_target()
	if target == null:
		return false
	_held = target
	if not target.choose():
		return false
	chosen.emit(target)
	return true


func _let_go() -> void:
	if is_instance_valid(_held):
		_held.let_go()
	_held = null


func _on_chosen(use: HandUse) -> void:
	if not enabled or not _counts(use):
		return
	use.touch()
	_point_with(use)
	_cast()
	if _choose():
		use.hand.pulse(CHOICE_PULSE)


func _show() -> void:
	var target := get_target()
	if enabled and not is_by_gaze():
		_marks.show_beam(_from, _direction, _distance)
	else:
		_marks.hide_beam()
	if target == null or not is_finite(_distance):
		_marks.hide_cursor()
		return
	var waits := is_by_gaze() and not _is_spent and _what != null
	waits = waits and is_finite(target.dwell_seconds())
	_marks.show_cursor(_from + _direction * _distance, head, get_dwell() if waits else -1.0)
