# SPDX-License-Identifier: MIT
class_name StarField
extends RefCounted
## Chooses stars whose images stand alone in a picture, so that each can be measured. A star is
## chosen for one order of image; its magnitude and temperature make that image white and give it
## the wanted light, whatever the hole does to it.

## White on the screen, so that no channel of an image clips before the others.
const WHITE_KELVIN: float = 6500.0
## Cooler stars give so little light unshifted that their magnitudes would leave every range.
const COOLEST_KELVIN: float = 2500.0
const ORDERS: int = 4
## Single precision: what is known of the direction of a star or of the hole, radians.
const ROUNDING: float = 1.2e-7
## Images on which that rounding shows by more pixels are not chosen: stars all but behind the hole.
const MOST_ROUNDING_PX: float = 0.01

## Temperature at which images are seen, unless the star would be cooler than COOLEST_KELVIN.
var seen_kelvin: float = WHITE_KELVIN
var directions: PackedVector3Array = []
var magnitudes: PackedFloat32Array = []
var temperatures: PackedFloat32Array = []
var targets: Array[Target] = []

var _view: ExactView
var _rng: RandomNumberGenerator
var _light: float
var _apart: float
var _spots: PackedVector2Array = []
var _sums: PackedFloat64Array = []


## One image to be measured.
class Target:
	extends RefCounted
	var order: int
	var pixel: Vector2
	var sum: float


## Stars anywhere, of which some stand alone in a picture (see `alone`).
static func random(rng: RandomNumberGenerator, count: int) -> StarField:
	var field := StarField.new(null, rng)
	for i in count:
		field.directions.append(field._somewhere())
		field.magnitudes.append(2.5 + 2.0 * rng.randf())
		field.temperatures.append(WHITE_KELVIN)
	return field


## `light`: summed luminance that the images get; `apart`: pixels between images.
func _init(
	view: ExactView, rng: RandomNumberGenerator, light: float = 2.0, apart: float = 14.0
) -> void:
	_view = view
	_rng = rng
	_light = light
	_apart = apart


## Adds up to `count` stars chosen for their image of this order.
func add(order: int, count: int, tries: int = 400) -> void:
	var found := 0
	for attempt in tries:
		if found >= count:
			return
		var star := _somewhere() if attempt % 2 == 0 and order > 0 else _in_view()
		if star != Vector3.ZERO and _add_star(star, order):
			found += 1


## Adds a star whose image of order 0 or 1 is seen at a place of the picture; false if it would
## disturb others, or nothing can be seen there.
func add_at(pixel: Vector2) -> bool:
	var direction := Vec3D.to_vector3(_view.to_direction(pixel))
	var ray: Dictionary = _view.observer.trace(_view.place, direction)
	if ray["captured"]:
		return false
	var star: Vector3 = ray["sky_direction"]
	for order in 2:
		if _view.star_spot(star, order).pixel.distance_to(pixel) < 0.05:
			return _add_star(star, order)
	return false


## Those images of these stars that stand alone in a picture and are bright enough, but not too
## bright, to be measured.
func alone(view: ExactView) -> Array[Target]:
	var spots: Array[Target] = []
	for i in directions.size():
		var flux := pow(10.0, -0.4 * magnitudes[i])
		for n in ORDERS:
			var spot := view.star_spot(directions[i], n)
			if spot.pixel != ExactView.NOWHERE:
				var image := Target.new()
				image.order = n
				image.pixel = spot.pixel
				image.sum = flux * view.luminance_sum(spot, temperatures[i])
				spots.append(image)
	var chosen: Array[Target] = []
	for spot in spots:
		if spot.sum > 0.3 and spot.sum < 3.0 and view.holds(spot.pixel, 20.0):
			if _stands_alone(spot, spots):
				chosen.append(spot)
	return chosen


## The catalogue of the stars chosen.
func catalogue() -> StarCatalogue:
	var stars := StarCatalogue.new()
	stars.set_stars(directions, magnitudes, temperatures)
	return stars


func _somewhere() -> Vector3:
	return Vector3(_rng.randfn(), _rng.randfn(), _rng.randfn()).normalized()


## What is seen at a random place of the picture; every second time near the hole.
func _in_view() -> Vector3:
	var pixel := Vector2(_rng.randf() * _view.size.x, _rng.randf() * _view.size.y)
	var hole := _view.to_pixel(Vec3D.scaled(_view.outward(), -1.0))
	if _rng.randf() < 0.5 and hole != ExactView.NOWHERE:
		var shadow := _view.focal() * tan(minf(_view.shadow_half_angle(), 1.5))
		var angle := _rng.randf() * TAU
		pixel = hole + Vector2.from_angle(angle) * (shadow + _rng.randf() * (shadow + 20.0))
	var direction := Vec3D.to_vector3(_view.to_direction(pixel))
	var ray: Dictionary = _view.observer.trace(_view.place, direction)
	return Vector3.ZERO if ray["captured"] else ray["sky_direction"]


func _add_star(star: Vector3, order: int) -> bool:
	var wanted := _view.star_spot(star, order)
	if wanted.pixel == ExactView.NOWHERE or not _view.holds(wanted.pixel, 20.0):
		return false
	if ROUNDING * _view.focal() * wanted.stretch > MOST_ROUNDING_PX:
		return false
	var kelvin := maxf(seen_kelvin / wanted.redshift, COOLEST_KELVIN)
	var flux := _light / _view.luminance_sum(wanted, kelvin)
	var spots: PackedVector2Array = []
	var sums: PackedFloat64Array = []
	for n in ORDERS:
		var spot := wanted if n == order else _view.star_spot(star, n)
		if spot.pixel == ExactView.NOWHERE:
			continue
		var light := flux * _view.luminance_sum(spot, kelvin)
		if n != order and _disturbs(spot.pixel, light, wanted.pixel):
			return false
		for target in targets:
			if _disturbs(spot.pixel, light, target.pixel):
				return false
		spots.append(spot.pixel)
		sums.append(light)
	for i in _spots.size():
		if _disturbs(_spots[i], _sums[i], wanted.pixel):
			return false
	_spots.append_array(spots)
	_sums.append_array(sums)
	directions.append(star)
	magnitudes.append(-2.5 * log(flux) / log(10.0))
	temperatures.append(kelvin)
	var chosen := Target.new()
	chosen.order = order
	chosen.pixel = wanted.pixel
	chosen.sum = _light
	targets.append(chosen)
	return true


func _stands_alone(image: Target, spots: Array[Target]) -> bool:
	for other in spots:
		if other != image and other.sum > 5e-4 * image.sum:
			if other.pixel.distance_to(image.pixel) < _apart:
				return false
	return true


## Would light of this sum at `spot` spoil the measurement of an image at `target`?
func _disturbs(spot: Vector2, light: float, target: Vector2) -> bool:
	return light > 5e-4 * _light and spot.distance_to(target) < _apart
