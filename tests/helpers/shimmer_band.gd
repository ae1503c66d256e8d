# SPDX-License-Identifier: MIT
class_name ShimmerBand
extends RefCounted
## Measures how much a ring-shaped band round the hole shimmers while the camera turns slowly.
##
## Steady motion changes a pixel's luminance L evenly from frame to frame, shimmer does not: of each
## pixel and three frames in a row the measure is |L(t+1) - 2 L(t) + L(t-1)|, as a share of the
## band's mean luminance. The light of the whole band, each pixel's luminance times its solid angle,
## stays the same as well: the sky turns with the hole, only the camera's pixels do not.

## Its summed light counts fully this many pixels within the band, and not at all at its borders.
const SOFT_PX: float = 4.0

var _inner: float
var _outer: float
var _pixels: PackedInt32Array = []
## Those that have a share in the band's light in some view.
var _lit_pixels: PackedInt32Array = []
## For each frame the luminance of the pixels that stay within the band.
var _frames: Array[PackedFloat32Array] = []
var _lights: PackedFloat64Array = []


## Between two angles from the hole, radians, for a camera that turns evenly from one view to
## another.
func _init(inner: float, outer: float, first: ExactView, last: ExactView) -> void:
	_inner = inner
	_outer = outer
	var margin := Vec3D.sine(first.forward, last.forward)
	var ahead := _ahead(first)
	var ahead_later := _ahead(last)
	for y in first.size.y:
		for x in first.size.x:
			var angle := _across(first, x, y).angle_to(ahead)
			if angle < inner - margin or angle > outer + margin:
				continue
			_lit_pixels.append(y * first.size.x + x)
			var later := _across(last, x, y).angle_to(ahead_later)
			if minf(angle, later) >= inner and maxf(angle, later) <= outer:
				_pixels.append(y * first.size.x + x)


## Adds a frame of linear light.
func add(picture: Image, view: ExactView) -> void:
	var copy: Image = picture.duplicate()
	copy.convert(Image.FORMAT_RGBF)
	var colours := copy.get_data().to_float32_array()
	var values: PackedFloat32Array = []
	for pixel in _pixels:
		values.append(_luminance(colours, pixel))
	_frames.append(values)
	_lights.append(_light(colours, view))


func pixel_count() -> int:
	return _pixels.size()


## The second difference that a share of all pixels and frames stays below, in units of the band's
## mean luminance.
func second_difference(share: float) -> float:
	var mean := 0.0
	var differences: PackedFloat32Array = []
	for t in range(1, _frames.size() - 1):
		for i in _pixels.size():
			var now := _frames[t][i]
			mean += now
			differences.append(absf(_frames[t + 1][i] - 2.0 * now + _frames[t - 1][i]))
	mean /= differences.size()
	differences.sort()
	return differences[ceili(share * differences.size()) - 1] / mean


## By how much the band's light varies from peak to peak.
func light_change() -> float:
	var sorted := _lights.duplicate()
	sorted.sort()
	return sorted[-1] / sorted[0] - 1.0


func _light(colours: PackedFloat32Array, view: ExactView) -> float:
	var total := 0.0
	var ahead := _ahead(view)
	var soft := SOFT_PX / view.focal()
	for pixel in _lit_pixels:
		@warning_ignore("integer_division")
		var across := _across(view, pixel % view.size.x, pixel / view.size.x)
		var angle := across.angle_to(ahead)
		var depth := minf(angle - _inner, _outer - angle) / soft
		# A pixel's solid angle goes with the cube of the cosine.
		total += smoothstep(0.0, 1.0, depth) * _luminance(colours, pixel) / pow(across.length(), 3)
	return total


static func _luminance(colours: PackedFloat32Array, pixel: int) -> float:
	var weights := PictureMeasure.WEIGHTS
	return (
		weights.x * colours[3 * pixel]
		+ weights.y * colours[3 * pixel + 1]
		+ weights.z * colours[3 * pixel + 2]
	)


## A pixel's direction in the camera's axes, to the right, down, ahead, as long as it comes.
static func _across(view: ExactView, x: int, y: int) -> Vector3:
	return Vector3(x + 0.5 - 0.5 * view.size.x, y + 0.5 - 0.5 * view.size.y, view.focal())


## The hole's direction in those axes.
static func _ahead(view: ExactView) -> Vector3:
	var hole := Vec3D.scaled(view.outward(), -1.0)
	return Vector3(
		Vec3D.dot(hole, view.right), -Vec3D.dot(hole, view.up), Vec3D.dot(hole, view.forward)
	)
