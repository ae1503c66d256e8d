# SPDX-License-Identifier: MIT
class_name PictureMeasure
extends RefCounted
## A picture as linear luminance, and what render tests measure in it.
##
## Positions are in pixels from the top left corner; the centre of the first pixel is (0.5, 0.5).
## Luminance is Rec. 709's of the linear colour: 1 is the white of an 8-bit picture.

const WEIGHTS: Vector3 = Vector3(0.2126, 0.7152, 0.0722)
## Formats with linear light; all others are taken as sRGB.
const LINEAR_FORMATS: Array[Image.Format] = [
	Image.FORMAT_RF,
	Image.FORMAT_RGF,
	Image.FORMAT_RGBF,
	Image.FORMAT_RGBAF,
	Image.FORMAT_RH,
	Image.FORMAT_RGH,
	Image.FORMAT_RGBH,
	Image.FORMAT_RGBAH,
	Image.FORMAT_RGBE9995,
]
## Samples per pixel along a ray.
const RAY_SAMPLES: int = 8

var width: int = 0
var height: int = 0
## Row after row from the top, width * height values.
var luminance: PackedFloat32Array = []


## Takes a picture: linear where its format is a float one, else 8-bit sRGB with the exact curve.
static func of_image(image: Image) -> PictureMeasure:
	var is_linear: bool = image.get_format() in LINEAR_FORMATS
	var copy: Image = image.duplicate()
	if copy.is_compressed():
		copy.decompress()
	copy.clear_mipmaps()
	copy.convert(Image.FORMAT_RGBF if is_linear else Image.FORMAT_RGB8)
	var values: PackedFloat32Array = (
		_of_floats(copy.get_data().to_float32_array()) if is_linear else _of_bytes(copy.get_data())
	)
	return of_luminance(values, copy.get_width())


## Takes luminances, row after row, of a picture so many pixels wide.
static func of_luminance(values: PackedFloat32Array, picture_width: int) -> PictureMeasure:
	var picture: PictureMeasure = PictureMeasure.new()
	picture.width = picture_width
	@warning_ignore("integer_division")
	picture.height = values.size() / picture_width
	picture.luminance = values
	return picture


## The luminance of a pixel; 0 outside the picture.
func at(x: int, y: int) -> float:
	if x < 0 or y < 0 or x >= width or y >= height:
		return 0.0
	return luminance[y * width + x]


## The luminance at any place, bilinear between pixel centres.
func sample(place: Vector2) -> float:
	var x: float = place.x - 0.5
	var y: float = place.y - 0.5
	var left: int = floori(x)
	var top: int = floori(y)
	var upper: float = lerpf(at(left, top), at(left + 1, top), x - left)
	var lower: float = lerpf(at(left, top + 1), at(left + 1, top + 1), x - left)
	return lerpf(upper, lower, y - top)


## The sum over the pixels whose centres lie within a radius, less a background per pixel.
func sum_around(centre: Vector2, radius: float, background: float = 0.0) -> float:
	var sum: float = 0.0
	for y: int in range(floori(centre.y - radius), ceili(centre.y + radius)):
		for x: int in range(floori(centre.x - radius), ceili(centre.x + radius)):
			if centre.distance_squared_to(Vector2(x + 0.5, y + 0.5)) <= radius * radius:
				sum += at(x, y) - background
	return sum


## The largest luminance among the pixels whose centres lie within a radius.
func maximum_around(centre: Vector2, radius: float) -> float:
	var found: float = 0.0
	for y: int in range(floori(centre.y - radius), ceili(centre.y + radius)):
		for x: int in range(floori(centre.x - radius), ceili(centre.x + radius)):
			if centre.distance_squared_to(Vector2(x + 0.5, y + 0.5)) <= radius * radius:
				found = maxf(found, at(x, y))
	return found


## The median over the pixels of the picture between two radii; 0 where there is none.
func background_around(centre: Vector2, inner: float, outer: float) -> float:
	var values: PackedFloat32Array = []
	for y: int in range(maxi(0, floori(centre.y - outer)), mini(height, ceili(centre.y + outer))):
		for x: int in range(
			maxi(0, floori(centre.x - outer)), mini(width, ceili(centre.x + outer))
		):
			var distance: float = centre.distance_to(Vector2(x + 0.5, y + 0.5))
			if distance >= inner and distance <= outer:
				values.append(luminance[y * width + x])
	if values.is_empty():
		return 0.0
	values.sort()
	@warning_ignore("integer_division")
	return values[values.size() / 2]


## Where a spot of light near an expected place is: its centroid under a round Gaussian window of
## window_sigma pixels that follows the spot, the background around it subtracted.
##
## For a Gaussian spot sampled at pixel centres the error is below 0.002 px from sigma 0.7 on.
## (NAN, NAN) where there is no light, or the spot is more than 2 window_sigma away.
func centroid(expected: Vector2, window_sigma: float = 2.0) -> Vector2:
	var background: float = background_around(expected, 4.0 * window_sigma, 6.0 * window_sigma)
	var place: Vector2 = expected
	for step: int in 100:
		var next: Vector2 = _windowed_mean(place, window_sigma, background)
		if not next.is_finite() or next.distance_to(expected) > 2.0 * window_sigma:
			return Vector2(NAN, NAN)
		if next.distance_to(place) < 1e-5:
			return next
		place = next
	return place


## The mean luminance at whole distances from a centre: entry i is over [i, i + 1) pixels.
func radial_profile(centre: Vector2, radius: int) -> PackedFloat32Array:
	var sums: PackedFloat32Array = []
	var counts: PackedInt32Array = []
	sums.resize(radius)
	counts.resize(radius)
	for y: int in range(maxi(0, floori(centre.y - radius)), mini(height, ceili(centre.y + radius))):
		for x: int in range(
			maxi(0, floori(centre.x - radius)), mini(width, ceili(centre.x + radius))
		):
			var ring: int = floori(centre.distance_to(Vector2(x + 0.5, y + 0.5)))
			if ring < radius:
				sums[ring] += luminance[y * width + x]
				counts[ring] += 1
	for ring: int in radius:
		sums[ring] /= maxi(counts[ring], 1)
	return sums


## Where rays from a centre leave a dark disk: for each of `rays` directions (clockwise from +x) the
## point between the radii `inner` and `outer` at which the luminance first reaches half the way
## from its level at `inner` to its level at `outer`. Rays that end outside the picture, or whose
## two levels are closer than `contrast`, are left out.
func edge_points(
	centre: Vector2, inner: float, outer: float, rays: int, contrast: float = 0.01
) -> PackedVector2Array:
	var points: PackedVector2Array = []
	var inside: Rect2 = Rect2(0.5, 0.5, width - 1.0, height - 1.0)
	for ray: int in rays:
		var direction: Vector2 = Vector2.from_angle(TAU * ray / rays)
		if not inside.has_point(centre + direction * outer):
			continue
		var low: float = sample(centre + direction * inner)
		var high: float = sample(centre + direction * outer)
		if high - low < contrast:
			continue
		points.append(centre + direction * _crossing(centre, direction, inner, (low + high) * 0.5))
	return points


## Pearson's correlation of two pictures of one size: 1 when one is a brighter copy of the other.
func correlation(other: PictureMeasure) -> float:
	return correlation_of(luminance, other.luminance)


## The same for two lists of one length; NAN where one of them is constant.
static func correlation_of(a: PackedFloat32Array, b: PackedFloat32Array) -> float:
	var mean_a: float = 0.0
	var mean_b: float = 0.0
	for i: int in a.size():
		mean_a += a[i]
		mean_b += b[i]
	mean_a /= a.size()
	mean_b /= b.size()
	var aa: float = 0.0
	var bb: float = 0.0
	var ab: float = 0.0
	for i: int in a.size():
		aa += (a[i] - mean_a) * (a[i] - mean_a)
		bb += (b[i] - mean_b) * (b[i] - mean_b)
		ab += (a[i] - mean_a) * (b[i] - mean_b)
	return ab / sqrt(aa * bb) if aa > 0.0 and bb > 0.0 else NAN


## A part of the picture as a picture of its own; outside the picture it is black.
func part(region: Rect2i) -> PictureMeasure:
	var values: PackedFloat32Array = []
	for y: int in range(region.position.y, region.end.y):
		for x: int in range(region.position.x, region.end.x):
			values.append(at(x, y))
	return of_luminance(values, region.size.x)


func _windowed_mean(place: Vector2, sigma: float, background: float) -> Vector2:
	var reach: float = 4.0 * sigma
	var sum: float = 0.0
	var sum_x: float = 0.0
	var sum_y: float = 0.0
	for y: int in range(floori(place.y - reach), ceili(place.y + reach)):
		for x: int in range(floori(place.x - reach), ceili(place.x + reach)):
			var dx: float = x + 0.5 - place.x
			var dy: float = y + 0.5 - place.y
			var window: float = exp(-(dx * dx + dy * dy) / (2.0 * sigma * sigma))
			var light: float = window * (at(x, y) - background)
			sum += light
			sum_x += light * dx
			sum_y += light * dy
	if sum <= 0.0:
		return Vector2(NAN, NAN)
	return place + Vector2(sum_x / sum, sum_y / sum)


func _crossing(centre: Vector2, direction: Vector2, inner: float, level: float) -> float:
	var step: float = 1.0 / RAY_SAMPLES
	var before: float = sample(centre + direction * inner)
	var radius: float = inner
	while true:
		radius += step
		var value: float = sample(centre + direction * radius)
		if value >= level:
			return radius - step * (value - level) / (value - before)
		before = value
	return NAN


static func _of_floats(colours: PackedFloat32Array) -> PackedFloat32Array:
	var values: PackedFloat32Array = []
	@warning_ignore("integer_division")
	values.resize(colours.size() / 3)
	var from: int = 0
	for i: int in values.size():
		values[i] = (
			WEIGHTS.x * colours[from]
			+ WEIGHTS.y * colours[from + 1]
			+ WEIGHTS.z * colours[from + 2]
		)
		from += 3
	return values


static func _of_bytes(colours: PackedByteArray) -> PackedFloat32Array:
	var red: PackedFloat32Array = []
	var green: PackedFloat32Array = []
	var blue: PackedFloat32Array = []
	for code: int in 256:
		var light: float = _linear_of_srgb(code / 255.0)
		red.append(WEIGHTS.x * light)
		green.append(WEIGHTS.y * light)
		blue.append(WEIGHTS.z * light)
	var values: PackedFloat32Array = []
	@warning_ignore("integer_division")
	values.resize(colours.size() / 3)
	var from: int = 0
	for i: int in values.size():
		values[i] = red[colours[from]] + green[colours[from + 1]] + blue[colours[from + 2]]
		from += 3
	return values


## IEC 61966-2-1.
static func _linear_of_srgb(value: float) -> float:
	return value / 12.92 if value <= 0.04045 else pow((value + 0.055) / 1.055, 2.4)
