# SPDX-License-Identifier: MIT
extends GutTest
## A lone star's light and colour, shifted by factors from 0.3 to 4, are those of the shifted black
## body. The shift is the Doppler effect of a flight without the hole.

const LIGHT: float = 2.0
## Below, black bodies lie outside of what screens show.
const COOLEST_SEEN: float = 1900.0
const TOLERANCE: float = 0.02
const TOLERANCE_XY: float = 0.005

var _booth: SkyBooth
var _star := Vector3(0.3, -0.2, -0.9).normalized()


func before_all() -> void:
	_booth = SkyBooth.new()
	_booth.sky.lensing = 0.0
	add_child(_booth)


func after_all() -> void:
	_booth.free()


func test_shifted_stars(kelvin: float = use_parameters([3000.0, 5772.0, 15000.0])) -> void:
	if not SkyBooth.is_linear():
		pending("Compatibility's eight bits tell no colours so finely")
		return
	var worst := 0.0
	var worst_xy := 0.0
	for g: float in [0.3, 0.5, 0.8, 1.0, 1.5, 2.5, 4.0]:
		var light := await _seen(kelvin, g)
		if kelvin * g < COOLEST_SEEN:
			continue
		var xyz := _xyz(light)
		worst = maxf(worst, absf(xyz.y / LIGHT - 1.0))
		var expected := _xyz(PlanckLight.colour(kelvin * g))
		worst_xy = maxf(worst_xy, absf(_sum_part(xyz, 0) - _sum_part(expected, 0)))
		worst_xy = maxf(worst_xy, absf(_sum_part(xyz, 1) - _sum_part(expected, 1)))
	gut.p("%s K: light %.2f %%, x and y %.4f" % [kelvin, 100.0 * worst, worst_xy])
	assert_lt(worst, TOLERANCE)
	assert_lt(worst_xy, TOLERANCE_XY)


## Below 1900 K the colour is drawn towards white, and the luminance stays.
func test_the_coolest_keep_their_luminance() -> void:
	if not SkyBooth.is_linear():
		pending("Compatibility's eight bits tell no colours so finely")
		return
	for kelvin: float in [3000.0, 5772.0]:
		var light := await _seen(kelvin, 0.3)
		assert_almost_eq(_xyz(light).y / LIGHT, 1.0, TOLERANCE, "%s K" % kelvin)
		assert_gte(minf(light.x, minf(light.y, light.z)), 0.0)


## Red, green and blue, summed over the star's picture.
func _seen(kelvin: float, g: float) -> Vector3:
	var view := ExactView.new(Vector3(0, 0, 10), LensingTable.MOTION_VELOCITY)
	view.observer.celerity = _star * (0.5 * (g - 1.0 / g))
	view.look_along(ExactView.doubled(_star + Vector3(0.04, 0.03, 0.0)), Vector3.UP)
	var pixel := view.to_pixel(ExactView.doubled(_star))
	var factor := PlanckLight.shift_factor(kelvin, g) / (g * g)
	var flux := LIGHT / (view.flat_luminance_sum(pixel) * factor)
	_booth.show_stars([_star], [-2.5 * log(flux) / log(10.0)], [kelvin])
	_booth.aim(view)
	var picture: Image = await _booth.take()
	var sum := Vector3.ZERO
	for y in range(-7, 8):
		for x in range(-7, 8):
			sum += PicturePatch.colour(picture, Vector2i(pixel) + Vector2i(x, y))
	return sum


## CIE XYZ of linear Rec.709.
static func _xyz(rgb: Vector3) -> Vector3:
	return Vector3(
		rgb.dot(Vector3(0.4124564, 0.3575761, 0.1804375)),
		rgb.dot(Vector3(0.2126729, 0.7151522, 0.0721750)),
		rgb.dot(Vector3(0.0193339, 0.1191920, 0.9503041))
	)


static func _sum_part(xyz: Vector3, axis: int) -> float:
	return xyz[axis] / (xyz.x + xyz.y + xyz.z)
