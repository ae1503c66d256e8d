# SPDX-License-Identifier: MIT
class_name StarTargets
extends RefCounted
## Stars chosen so that an image of each stands alone in the picture, with known place and light.

const WHITE_KELVIN: float = 6500.0
## Summed luminance of each image: bright, and white at no pixel.
const LIGHT: float = 2.0
## Pixels between a measured image and any other.
const APART: float = 16.0
## Focal length in pixels of 60 degrees over 720 rows, and the light of a star of magnitude 0 there.
const REFERENCE_FOCAL_PX: float = 623.538290724796
const STAR_GAIN: float = 30.0
const ORDERS: int = 2

var directions: PackedVector3Array = []
var magnitudes: PackedFloat32Array = []
var kelvins: PackedFloat32Array = []
var pixels: PackedVector2Array = []
var orders: PackedInt32Array = []

var _stage: SelfTestStage
var _place: Vector3
var _observer: SkyObserver
var _images: PackedVector2Array = []


## Chooses among stars seen at 36 places round the middle of the stage's picture.
func _init(stage: SelfTestStage, place: Vector3, observer: SkyObserver) -> void:
	_stage = stage
	_place = place
	_observer = observer
	var centre := 0.5 * Vector2(stage.viewport.size)
	for i in 36:
		# No two opposite each other: there the other image of the star lies.
		var radius := centre.x * (0.3 + 0.6 * fposmod(0.38 * i, 1.0))
		_consider(centre + Vector2.from_angle(TAU * i / 37.0) * radius)


## Those stars.
func catalogue() -> StarCatalogue:
	var stars := StarCatalogue.new()
	stars.set_stars(directions, magnitudes, kelvins)
	return stars


## Luminance, summed over its image, of an undisturbed star of magnitude 0 seen at a place.
static func flat_light(stage: SelfTestStage, pixel: Vector2) -> float:
	var cos_axis := stage.to_direction(pixel).dot(-stage.camera.basis.z)
	return STAR_GAIN * pow(stage.focal() / REFERENCE_FOCAL_PX, 2) / pow(cos_axis, 3)


## The magnitude of a star whose flux is so many times that of magnitude 0.
static func magnitude_of(flux: float) -> float:
	return -2.5 * log(flux) / log(10.0)


func _consider(pixel: Vector2) -> void:
	var ray: Dictionary = _observer.trace(_place, _stage.to_direction(pixel))
	if ray["captured"]:
		return
	var star: Vector3 = ray["sky_direction"]
	var seen: PackedVector2Array = []
	var order := -1
	var image := {}
	for n in ORDERS:
		var exact: Dictionary = _observer.star_image(_place, star, n)
		var direction: Vector3 = exact["direction"]
		if direction.dot(-_stage.camera.basis.z) < 0.1:
			seen.append(Vector2(INF, INF))
			continue
		seen.append(_stage.to_pixel(direction))
		if seen[n].distance_to(pixel) < 0.5:
			order = n
			image = exact
	if order >= 0 and _is_free(seen):
		_add(star, seen[order], order, image)
		_images.append_array(seen)


func _is_free(seen: PackedVector2Array) -> bool:
	for spot in seen:
		for other in _images:
			if spot.is_finite() and spot.distance_to(other) < APART:
				return false
	return seen[0].distance_to(seen[1]) > APART


func _add(star: Vector3, pixel: Vector2, order: int, image: Dictionary) -> void:
	var redshift: float = image["redshift"]
	var magnification: float = image["magnification"]
	var kelvin := WHITE_KELVIN / redshift
	var shift := pow(2.0, BlackBody.log2_luminance(WHITE_KELVIN) - BlackBody.log2_luminance(kelvin))
	directions.append(star)
	kelvins.append(kelvin)
	magnitudes.append(magnitude_of(LIGHT / (flat_light(_stage, pixel) * magnification * shift)))
	pixels.append(pixel)
	orders.append(order)
