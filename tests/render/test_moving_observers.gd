# SPDX-License-Identifier: MIT
extends GutTest
## Observers who fall, orbit or fly: images of stars stand where the exact solution puts them, as
## bright as it says.

const WANTED: int = 12
const MOST_PICTURES: int = 8

var _observers: Array = [
	# motion, properties, distance
	[LensingTable.MOTION_INFALL, {"energy": 1.6}, 4.0],
	[LensingTable.MOTION_INFALL, {"energy": 1.6, "outgoing": true}, 4.0],
	[LensingTable.MOTION_INFALL, {"energy": 3.0}, 0.7],
	[LensingTable.MOTION_ORBIT, {"axis": Vector3(0.2, 1.0, -0.1)}, 1.8],
	[LensingTable.MOTION_ORBIT, {"axis": Vector3(-0.2, -1.0, 0.3)}, 6.0],
	[LensingTable.MOTION_VELOCITY, {"celerity": Vector3(0.6, -0.9, 1.1)}, 3.0],
	[LensingTable.MOTION_VELOCITY, {"celerity": Vector3(0.6, -0.9, 1.1)}, 0.5],
	[
		LensingTable.MOTION_VELOCITY,
		{"celerity": Vector3(-0.8, 0.3, 0.4), "relative_to_static": true},
		20.0
	],
]
var _booth: SkyBooth
var _rng := RandomNumberGenerator.new()


func before_all() -> void:
	_booth = SkyBooth.new()
	add_child(_booth)


func after_all() -> void:
	_booth.free()


func test_places_and_light(p: Array = use_parameters(_observers)) -> void:
	_rng.seed = 31
	var worst := 0.0
	var worst_light := 0.0
	var count := 0
	for picture in MOST_PICTURES:
		var view := _view(p)
		var field := StarField.new(view, _rng)
		for order in 3:
			field.add(order, 5)
		if field.targets.is_empty():
			continue
		_booth.sky.catalogue = field.catalogue()
		_booth.aim(view)
		var image: Image = await _booth.take()
		for target in field.targets:
			var off := PicturePatch.centroid(image, target.pixel).distance_to(target.pixel)
			worst = off if not off <= worst else worst
			count += 1
			if SkyBooth.is_linear():
				var light := PicturePatch.light(image, target.pixel, 7)
				worst_light = maxf(worst_light, absf(light / target.sum - 1.0))
		if count >= WANTED:
			break
	gut.p("%d images, worst %.4f px, light %.2f %%" % [count, worst, 100.0 * worst_light])
	assert_gte(count, WANTED)
	assert_lt(worst, 0.05 if SkyBooth.is_linear() else 0.08)
	assert_lt(worst_light, 0.02)


func _view(p: Array) -> ExactView:
	var distance: float = p[2]
	var view := ExactView.new(_direction() * distance, p[0])
	var properties: Dictionary = p[1]
	for property: String in properties:
		view.observer.set(property, properties[property])
	var shadow := view.observer.shadow(view.place)
	var towards: Vector3 = shadow["direction"]
	var half: float = shadow["half_angle"]
	var aside := towards.cross(_direction()).normalized()
	var beside := half + 0.15 + 0.5 * _rng.randf()
	view.look_along(ExactView.doubled(towards * cos(beside) + aside * sin(beside)), _direction())
	return view


func _direction() -> Vector3:
	return Vector3(_rng.randfn(), _rng.randfn(), _rng.randfn()).normalized()
