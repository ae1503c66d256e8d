# SPDX-License-Identifier: MIT
class_name HoleCards
extends Node3D
## Cards beside the hole about what is seen there: the photon sphere, the Einstein ring and the
## horizon. One is open at a time; the others are tags that can be chosen.
##
## They stand at the hole's distance, so that they keep beside it when the head moves, and come
## along when the head has gone some way round the hole or to it.

## A card has been opened; -1: all are closed.
signal opened(index: int)

enum Subject { PHOTON_SPHERE, EINSTEIN_RING, HORIZON }

const CARD: PackedScene = preload("res://scenes/xr/cards/hole_card.tscn")
## To which side of the hole each stands, and whether above its middle or below it: a round shadow
## leaves most room in the corners of the field of view.
const SIDES: PackedFloat32Array = [1.0, -1.0, 1.0]
const RISES: PackedFloat32Array = [1.0, 1.0, -1.0]
## Sine of the angle at which a card's inner corner stands over the hole's middle, as long as the
## card's middle is not farther up or down than this, degrees.
const SLANT: float = 0.62
const MOST_RISE: float = 22.0
## Between cards one above the other, degrees.
const BETWEEN: float = 1.6
## Beyond this angle from the hole's middle there is no place for cards, degrees.
const FARTHEST: float = 100.0
## Time between two looks where the leaders lead to, and in which they get there, seconds.
const LOOK_SECONDS: float = 0.1

@export var sky: BlackHoleSky
@export var head: Node3D
## Height of a line of text as seen from the head.
@export_range(2.0, 6.0, 0.1, "suffix:°") var text_degrees: float = 2.6
## Between the shadow's edge and the cards.
@export_range(0.5, 10.0, 0.1, "suffix:°") var clearance: float = 1.5
## They are placed anew when the head has gone so far round the hole,
@export_range(5.0, 90.0, 1.0, "suffix:°") var most_turn: float = 25.0
## or when its distance has changed by this part.
@export_range(0.05, 0.9, 0.01) var most_change: float = 0.25
## They take so long to get there.
@export_range(0.05, 2.0, 0.05, "suffix:s") var ease_seconds: float = 0.4

var _cards: Array[HoleCard] = []
var _leaders: Array[CardLeader] = []
var _open: int = Subject.PHOTON_SPHERE
var _sights := HoleSights.new()
var _places: Array[Transform3D] = []
var _tips: PackedVector3Array = [Vector3.ZERO, Vector3.ZERO, Vector3.ZERO]
var _tips_now: PackedVector3Array = [Vector3.ZERO, Vector3.ZERO, Vector3.ZERO]
var _placed_from := Vector3.ZERO
var _is_placed: bool = false
var _since_look: float = INF


func _ready() -> void:
	top_level = true
	_sights.sky = sky
	for subject: int in Subject.values():
		var card: HoleCard = CARD.instantiate()
		var leader := CardLeader.new()
		add_child(card)
		add_child(leader)
		card.text_degrees = text_degrees
		card.chosen.connect(open.bind(subject))
		_cards.append(card)
		_leaders.append(leader)
		_places.append(Transform3D.IDENTITY)
	_write()


func _notification(what: int) -> void:
	if what == NOTIFICATION_TRANSLATION_CHANGED and is_node_ready():
		_write()
		_place(false)
	elif what == NOTIFICATION_VISIBILITY_CHANGED:
		_is_placed = false


func _process(delta: float) -> void:
	if not is_visible_in_tree():
		return
	global_transform = Transform3D(Basis.IDENTITY, sky.global_position)
	var eye := head.global_position - sky.global_position
	if not _is_placed or _is_elsewhere(eye):
		_place(not _is_placed)
	_since_look += delta
	if _since_look >= LOOK_SECONDS:
		_since_look = 0.0
		# A hole that has come, or gone, since they were placed.
		_is_placed = _sights.look_from(head.global_position) == has_room()
		_look()
	_ease(delta, eye)


## Opens one card, one of Subject, and closes the others; -1 closes all.
func open(index: int) -> void:
	_open = clampi(index, -1, _cards.size() - 1)
	for i in _cards.size():
		_cards[i].set_open(i == _open)
	_place(false)
	opened.emit(_open)


## Opens the next card, round and round.
func open_next() -> void:
	open((_open + 1) % _cards.size())


## Which is open, one of Subject; -1: none.
func get_open() -> int:
	return _open


func get_card(index: int) -> HoleCard:
	return _cards[index]


## Where a card's leader leads to, in the world.
func get_tip(index: int) -> Vector3:
	return global_position + _tips_now[index]


## Can cards be placed for the head's place?
func has_room() -> bool:
	return _cards[0].visible


func _write() -> void:
	_cards[Subject.PHOTON_SPHERE].set_content(
		tr("Photon sphere"),
		tr("At 1.5 radii light can circle the hole. It draws the edge of the shadow.")
	)
	_cards[Subject.EINSTEIN_RING].set_content(
		tr("Einstein ring"),
		tr("Light from straight behind the hole is bent round all its sides: a ring.")
	)
	_cards[Subject.HORIZON].set_content(
		tr("Horizon"), tr("Nothing comes back. Light bends: the shadow is up to 2.6 times as wide.")
	)
	for i in _cards.size():
		_cards[i].set_open(i == _open)


func _is_elsewhere(eye: Vector3) -> bool:
	var change := eye.length() / maxf(_placed_from.length(), 1e-6)
	return eye.angle_to(_placed_from) > deg_to_rad(most_turn) or absf(change - 1.0) > most_change


# Finds places for all cards as seen from the head now.
func _place(at_once: bool) -> void:
	if not is_inside_tree() or not is_visible_in_tree():
		return
	var place := head.global_position
	var is_there := _sights.look_from(place)
	var eye := place - sky.global_position
	var change := eye.length() / maxf(_placed_from.length(), 1e-6)
	at_once = at_once or change > 2.0 or change < 0.5 or not has_room()
	_placed_from = eye
	_is_placed = true
	if is_there:
		var axes := _axes()
		for i in _cards.size():
			var direction := _direction_of(i, axes)
			is_there = is_there and direction != Vector3.ZERO
			if not is_there:
				break
			_places[i] = Transform3D(
				_turned(direction, axes).scaled(Vector3.ONE * eye.length()),
				eye + direction * eye.length()
			)
	for i in _cards.size():
		_cards[i].visible = is_there
		_leaders[i].visible = is_there
		if at_once:
			_cards[i].transform = _places[i]
	if is_there:
		_look()
		if at_once:
			_tips_now = _tips.duplicate()


# Right, up and back for one who looks at the shadow's middle.
func _axes() -> Basis:
	var rig := head.get_parent_node_3d()
	var up := rig.global_basis.y.normalized() if rig != null else Vector3.UP
	if absf(up.dot(_sights.centre)) > 0.95:
		up = head.global_basis.y.normalized()
	return Basis.looking_at(_sights.centre, up)


# As near to the shadow as may be; zero: there is no place.
func _direction_of(index: int, axes: Basis) -> Vector3:
	var half := 0.5 * _cards[index].get_size()
	var free := _sights.half_angle + deg_to_rad(clearance)
	var rise := minf(SLANT * free + half.y, deg_to_rad(MOST_RISE))
	rise = RISES[index] * maxf(rise, half.y + 0.5 * deg_to_rad(BETWEEN))
	var aside := atan(half.x)
	while aside < deg_to_rad(FARTHEST):
		var direction := (
			axes
			* Vector3(SIDES[index] * sin(aside) * cos(rise), sin(rise), -cos(aside) * cos(rise))
		)
		if _nearest_angle(direction, axes, half) >= free:
			return direction
		aside += 0.004
	return Vector3.ZERO


# Turned as an eye turns from the shadow's middle to there, the straight way: lines are then seen
# level both from the corner of the eye and when one looks at them.
func _turned(direction: Vector3, axes: Basis) -> Basis:
	return Basis(Quaternion(_sights.centre, direction)) * axes


# Between the shadow's middle and the nearest point of a card in this direction, radians.
func _nearest_angle(direction: Vector3, axes: Basis, half: Vector2) -> float:
	var middle := _turned(direction, axes).inverse() * _sights.centre
	if middle.z >= -0.01:
		return _sights.centre.angle_to(direction) - half.length()
	var hit := Vector2(middle.x, middle.y) / -middle.z
	var nearest := hit.clamp(-half, half)
	return middle.angle_to(Vector3(nearest.x, nearest.y, -1.0))


# Where the leaders lead to now.
func _look() -> void:
	if not has_room() or not _sights.look_from(head.global_position):
		return
	var eye := head.global_position - sky.global_position
	for i in _cards.size():
		var card := _places[i]
		var side := card.origin - eye
		var tip := _seen(i, side)
		# Not behind the card itself: farther up along the ring.
		for step in 12:
			if not _covers(card, i, eye, tip):
				break
			side = side.rotated(_sights.centre, -SIDES[i] * deg_to_rad(5.0))
			tip = _seen(i, side)
		_tips[i] = eye + tip * eye.length()


func _seen(index: int, side: Vector3) -> Vector3:
	match index:
		Subject.PHOTON_SPHERE:
			return _sights.edge_towards(side)
		Subject.EINSTEIN_RING:
			return _sights.ring_towards(side)
	return _sights.centre


func _covers(card: Transform3D, index: int, eye: Vector3, direction: Vector3) -> bool:
	var seen := card.basis.orthonormalized().inverse() * direction
	var away := card.origin.distance_to(eye)
	if seen.z >= -0.01 or away <= 0.0:
		return false
	var half := 0.5 * _cards[index].get_size() + Vector2.ONE * deg_to_rad(CardLeader.RING)
	return absf(seen.x / seen.z) < half.x and absf(seen.y / seen.z) < half.y


func _ease(delta: float, eye: Vector3) -> void:
	if not has_room():
		return
	var weight := 1.0 - exp(-delta / (0.4 * ease_seconds))
	var weight_of_tips := 1.0 - exp(-delta / LOOK_SECONDS)
	for i in _cards.size():
		var card := _cards[i]
		if not card.transform.is_equal_approx(_places[i]):
			card.transform = card.transform.interpolate_with(_places[i], weight)
		_tips_now[i] = _tips_now[i].lerp(_tips[i], weight_of_tips)
		var half := 0.5 * card.get_size()
		var tip := card.transform.affine_inverse() * _tips_now[i]
		var anchor := Vector3(clampf(tip.x, -half.x, half.x), clampf(tip.y, -half.y, half.y), 0.0)
		_leaders[i].lead(card.transform * anchor, _tips_now[i], eye)
