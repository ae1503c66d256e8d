# SPDX-License-Identifier: MIT
class_name CornerFinder
extends RefCounted
## Finds the corner of a checkerboard in a picture to a small part of a pixel: the place from which
## all edges round it run away straight (Foerstner and Guelch 1987).

const NOWHERE := Vector2(INF, INF)
const ROUNDS: int = 12

var _luminance: PackedFloat32Array
var _size: Vector2i


func _init(luminance: PackedFloat32Array, size: Vector2i) -> void:
	_luminance = luminance
	_size = size


static func of_picture(picture: Image) -> CornerFinder:
	return CornerFinder.new(PictureMeasure.of_image(picture).luminance, picture.get_size())


## The corner next to a place, looked for within `reach` pixels; NOWHERE if there is none. Pixel
## centres lie at +0.5.
func near(place: Vector2, reach: int) -> Vector2:
	var found := place
	for i in ROUNDS:
		var next := _step(found, reach)
		if next == NOWHERE or next.distance_to(place) > reach:
			return NOWHERE
		if next.distance_to(found) < 1e-4:
			return next
		found = next
	return found


func _step(place: Vector2, reach: int) -> Vector2:
	var middle := Vector2i(place.floor())
	if not Rect2i(Vector2i.ONE * (reach + 1), _size - Vector2i.ONE * 2 * (reach + 1)).has_point(
		middle
	):
		return NOWHERE
	# Normal equations of the point whose connection to each pixel lies across the gradient there.
	var xx := 0.0
	var xy := 0.0
	var yy := 0.0
	var right_x := 0.0
	var right_y := 0.0
	for y in range(middle.y - reach, middle.y + reach + 1):
		for x in range(middle.x - reach, middle.x + reach + 1):
			var at := Vector2(x + 0.5, y + 0.5)
			var weight := exp(-2.0 * at.distance_squared_to(place) / (reach * reach))
			var i := y * _size.x + x
			var gx := _luminance[i + 1] - _luminance[i - 1]
			var gy := _luminance[i + _size.x] - _luminance[i - _size.x]
			xx += weight * gx * gx
			xy += weight * gx * gy
			yy += weight * gy * gy
			right_x += weight * (gx * gx * at.x + gx * gy * at.y)
			right_y += weight * (gx * gy * at.x + gy * gy * at.y)
	var determinant := xx * yy - xy * xy
	if determinant <= 1e-3 * xx * yy or determinant < 1e-8:
		return NOWHERE
	return Vector2(yy * right_x - xy * right_y, xx * right_y - xy * right_x) / determinant
