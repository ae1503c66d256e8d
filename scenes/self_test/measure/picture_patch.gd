# SPDX-License-Identifier: MIT
class_name PicturePatch
extends RefCounted
## A small part of a big picture, measured: reading all of 1280x720 for one star would take longer
## than drawing it.

var measure: PictureMeasure
var corner: Vector2


## The pixels up to `radius` pixels from the one at `centre`.
static func around(picture: Image, centre: Vector2, radius: int) -> PicturePatch:
	var middle := Vector2i(centre.floor())
	var region := Rect2i(
		middle - Vector2i(radius, radius), Vector2i(2 * radius + 1, 2 * radius + 1)
	)
	return of_region(picture, region)


## The pixels of a rectangle, as far as it lies in the picture.
static func of_region(picture: Image, region: Rect2i) -> PicturePatch:
	var inside := region.intersection(Rect2i(Vector2i.ZERO, picture.get_size()))
	var patch := PicturePatch.new()
	patch.corner = Vector2(inside.position)
	patch.measure = PictureMeasure.of_image(picture.get_region(inside))
	return patch


## Centroid of the star near `expected` of a picture whose point spread is one pixel wide.
static func centroid(picture: Image, expected: Vector2) -> Vector2:
	var patch := around(picture, expected, 9)
	return patch.measure.centroid(expected - patch.corner, 1.5) + patch.corner


## Summed luminance of all pixels within `radius` of `centre`, as a square.
static func light(picture: Image, centre: Vector2, radius: int) -> float:
	var total := 0.0
	for value in around(picture, centre, radius).measure.luminance:
		total += value
	return total


## Luminance at a place of the picture, between pixel centres interpolated linearly.
static func sample(picture: Image, at: Vector2) -> float:
	var patch := around(picture, at, 1)
	return patch.measure.sample(at - patch.corner)


## Linear red, green and blue of a pixel.
static func colour(picture: Image, at: Vector2i) -> Vector3:
	var c := picture.get_pixelv(at)
	if picture.get_format() not in PictureMeasure.LINEAR_FORMATS:
		c = c.srgb_to_linear()
	return Vector3(c.r, c.g, c.b)
