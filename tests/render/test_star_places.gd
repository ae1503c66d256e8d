# SPDX-License-Identifier: MIT
extends GutTest
## Images of stars, orders 0 to 3, stand where the exact solution puts them.

const WANTED_PER_ORDER: int = 5
const MOST_PICTURES: int = 14
const PICTURES_AT_60_DEGREES: int = 8

var _observers: Array = [
	[LensingTable.MOTION_STATIC, 1.2],
	[LensingTable.MOTION_STATIC, 1.6],
	[LensingTable.MOTION_STATIC, 3.0],
	[LensingTable.MOTION_STATIC, 10.0],
	[LensingTable.MOTION_STATIC, 100.0],
	[LensingTable.MOTION_STATIC, 1e4],
	[LensingTable.MOTION_RAIN, 10.0],
	[LensingTable.MOTION_RAIN, 1.0],
	[LensingTable.MOTION_RAIN, 0.5],
	[LensingTable.MOTION_RAIN, 0.1],
]
var _booth: SkyBooth
var _rng := RandomNumberGenerator.new()
var _counts: PackedInt32Array = []
var _worst: PackedFloat64Array = []


func before_all() -> void:
	_booth = SkyBooth.new()
	add_child(_booth)


func after_all() -> void:
	_booth.free()


func before_each() -> void:
	_rng.seed = 20
	_counts = [0, 0, 0, 0]
	_worst = [0.0, 0.0, 0.0, 0.0]


func test_centroids(p: Array = use_parameters(_observers)) -> void:
	var motion: LensingTable.Motion = p[0]
	var r: float = p[1]
	for picture in MOST_PICTURES:
		var view := ExactView.new(_direction() * r, motion)
		_aim(view, picture)
		await _measure(view, 3 - picture % 4)
		if picture >= 2 and _enough():
			break
	_judge("%s r = %s" % ["static" if motion == LensingTable.MOTION_STATIC else "rain", r])


## The shadow's edge first, where all orders crowd; then further out; then wherever the dice point;
## then the edge again until there is enough of each order.
func _aim(view: ExactView, picture: int) -> void:
	var edge := view.shadow_half_angle()
	var turn := _rng.randf() * TAU
	match picture:
		0:
			view.look_beside(edge, _direction(), turn)
		1:
			view.look_beside(minf(edge + 0.6, 3.0), _direction(), turn)
		2:
			view.look_beside(maxf(edge, _rng.randf() * PI), _direction(), turn)
		_:
			view.look_beside(edge + 0.2 * _rng.randf(), _direction(), turn)
	if picture < PICTURES_AT_60_DEGREES:
		return
	# Orders that crowd within a few pixels even so are told apart in a narrower field.
	if view.place.length() < 0.2:
		view.vertical_fov_deg = 12.0
	elif view.place.length() > 1000.0:
		view.vertical_fov_deg = 0.3
		view.look_beside(edge * _rng.randf(), _direction(), turn)


func _measure(view: ExactView, first_order: int) -> void:
	var field := StarField.new(view, _rng)
	for i in 4:
		field.add((first_order + 4 - i) % 4, 6)
	if field.targets.is_empty():
		return
	_booth.sky.catalogue = field.catalogue()
	# Far away the world is made smaller, as the captures do.
	_booth.aim(view, minf(1.0, 1000.0 / view.place.length()))
	var picture: Image = await _booth.take()
	for target in field.targets:
		var off := PicturePatch.centroid(picture, target.pixel).distance_to(target.pixel)
		_counts[target.order] += 1
		# A picture without the star has no centroid: not a number, which no tolerance admits.
		_worst[target.order] = off if not off <= _worst[target.order] else _worst[target.order]


func _enough() -> bool:
	for count in _counts:
		if count < WANTED_PER_ORDER:
			return false
	return true


func _judge(whose: String) -> void:
	var tolerance := 0.05 if SkyBooth.is_linear() else 0.08
	gut.p("%s: %s images, worst %s px" % [whose, _counts, _worst])
	for order in 4:
		assert_gte(_counts[order], WANTED_PER_ORDER, "%s: images of order %d" % [whose, order])
		assert_lt(_worst[order], tolerance, "%s: worst centroid of order %d" % [whose, order])


func _direction() -> Vector3:
	return Vector3(_rng.randfn(), _rng.randfn(), _rng.randfn()).normalized()
