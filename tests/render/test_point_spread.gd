# SPDX-License-Identifier: MIT
extends GutTest
## The light of a star, however it is spread: its sum, its place and, for diffraction, its shape.

const TOLERANCE: float = 0.02
## What 8 bits may lose of faint wings, and how much light of a star they hold.
const MOST_LOST: float = 0.35
const MOST_LIGHT_8_BITS: float = 2.0
const CENTROID_TOLERANCE: float = 0.05
const GAUSSIAN := BlackHoleSky.PSF_GAUSSIAN
const AIRY := BlackHoleSky.PSF_AIRY
const EYE := BlackHoleSky.PSF_EYE

## Model, pixels of the Gaussian, aperture in mm, glare, light of a star.
var _spreads: Array = [
	[GAUSSIAN, 1.0, 5.0, 0.6, 2.0],
	[AIRY, 1.0, 0.15, 0.6, 2.0],
	[AIRY, 1.0, 5.0, 0.6, 2.0],
	[AIRY, 0.7, 0.4, 0.6, 0.05],
	[EYE, 1.0, 5.0, 0.616, 2.0],
	[EYE, 0.7, 5.0, 1.0, 20.0],
	[EYE, 1.5, 5.0, 0.1, 0.05],
]
var _booth: SkyBooth
var _rng := RandomNumberGenerator.new()

@warning_ignore("untyped_declaration")
func should_skip_script():
	return RendererScope.without_forward_plus()


func before_all() -> void:
	_booth = SkyBooth.new()
	add_child(_booth)


func after_all() -> void:
	_booth.free()


func before_each() -> void:
	_rng.seed = 7
	_booth.sky.faint_limit = 5e-5


func test_light_and_place(spread: Array = use_parameters(_spreads)) -> void:
	_choose(spread)
	var view := ExactView.new(Vector3(3, 2, -4), LensingTable.MOTION_STATIC)
	view.look_beside(0.9, Vector3(1, 2, 0.5))
	var light_wanted: float = spread[4]
	if not SkyBooth.is_linear():
		light_wanted = minf(light_wanted, MOST_LIGHT_8_BITS)
	var field := _grid(view, light_wanted)
	var picture: Image = await _photograph(view, field)
	var worst := 0.0
	var farthest := 0.0
	for target in field.targets:
		var light := PicturePatch.light(picture, target.pixel, 80)
		var off := light / target.sum - 1.0
		worst = off if not absf(off) <= absf(worst) else worst
		var found := PicturePatch.centroid(picture, target.pixel)
		farthest = maxf(farthest, found.distance_to(target.pixel))
	gut.p("%s: light %.3f %%, place %.4f px" % [spread, 100.0 * worst, farthest])
	assert_gte(field.targets.size(), 9, "stars measured")
	assert_between(worst, -TOLERANCE if SkyBooth.is_linear() else -MOST_LOST, TOLERANCE, "light")
	assert_lt(farthest, CENTROID_TOLERANCE, "place")


func test_fields_of_view(
	p: Array = use_parameters([[AIRY, 8.0], [AIRY, 1.5], [EYE, 8.0], [EYE, 1.5], [EYE, 110.0]])
) -> void:
	_choose([p[0], 1.0, 3.0, 0.616])
	var view := ExactView.new(Vector3(3, 2, -4), LensingTable.MOTION_STATIC)
	view.vertical_fov_deg = p[1]
	view.look_beside(0.9, Vector3(1, 2, 0.5))
	var field := _grid(view, 2.0)
	var picture: Image = await _photograph(view, field)
	var worst := 0.0
	for target in field.targets:
		var off := PicturePatch.light(picture, target.pixel, 80) / target.sum - 1.0
		worst = off if not absf(off) <= absf(worst) else worst
	gut.p("%s: light %.3f %%" % [p, 100.0 * worst])
	assert_gte(field.targets.size(), 9, "stars measured")
	assert_between(worst, -TOLERANCE if SkyBooth.is_linear() else -MOST_LOST, TOLERANCE, "light")


func test_diffraction_rings(
	# vertical field in degrees, aperture in mm
	p: Array = use_parameters([[20.0, 0.1], [1.5, 1.3]])
) -> void:
	_choose([AIRY, 0.6, p[1], 0.0])
	var view := ExactView.new(Vector3(3, 2, -4), LensingTable.MOTION_STATIC)
	view.vertical_fov_deg = p[0]
	view.look_beside(0.9, Vector3(1, 2, 0.5))
	var field := StarField.new(view, _rng, 400.0 if SkyBooth.is_linear() else 100.0, 100.0)
	field.add_at(Vector2(640.3, 360.8))
	assert_eq(field.targets.size(), 1)
	var picture: Image = await _photograph(view, field)
	var dark: PackedFloat64Array = []
	for channel in 3:
		var scale := AiryPattern.scale(channel, p[1]) * view.focal()
		dark.append(_first_dark_ring(picture, field.targets[0].pixel, channel, scale))
		assert_almost_eq(
			dark[channel] / scale, AiryPattern.FIRST_ZERO, 0.05 * AiryPattern.FIRST_ZERO
		)
		if SkyBooth.is_linear():
			_judge_profile(picture, field.targets[0].pixel, channel, scale)
	gut.p("%s: dark rings at %s px" % [p, dark])
	assert_gt(dark[0], dark[1] * 1.05, "red rings are wider than green ones")
	assert_gt(dark[1], dark[2] * 1.1, "green rings are wider than blue ones")


func test_bright_stars_are_larger() -> void:
	for model: BlackHoleSky.PointSpreadModel in [AIRY, EYE]:
		_choose([model, 1.0, 1.0, 0.616])
		var reaches: PackedInt32Array = []
		for light: float in [0.02, 2.0, 200.0]:
			var view := ExactView.new(Vector3(3, 2, -4), LensingTable.MOTION_STATIC)
			view.look_beside(0.9, Vector3(1, 2, 0.5))
			var field := StarField.new(view, _rng, light, 100.0)
			field.add_at(Vector2(640.5, 360.5))
			reaches.append(_reach(await _photograph(view, field)))
		gut.p("model %s: lit to %s px" % [model, reaches])
		assert_between(reaches[0], 2, 8, "a faint star is small")
		assert_gt(reaches[1], reaches[0], "a bright star is larger")
		assert_gt(reaches[2], 2 * reaches[1] - 4, "a brilliant star is larger still")
		assert_lte(reaches[2], 256, "within the bound")


func _choose(spread: Array) -> void:
	_booth.sky.psf_model = spread[0]
	_booth.sky.psf_sigma = spread[1]
	_booth.sky.aperture_mm = spread[2]
	_booth.sky.glare = spread[3]


## Stars far apart, on and off pixel centres.
func _grid(view: ExactView, light: float) -> StarField:
	var field := StarField.new(view, _rng, light, 160.0)
	for row in 3:
		for column in 5:
			var offset := Vector2(0.5 + 0.25 * column, 0.5 + 0.33 * row)
			field.add_at(Vector2(140 + 250 * column, 120 + 240 * row) + offset)
	return field


func _photograph(view: ExactView, field: StarField) -> Image:
	_booth.sky.catalogue = field.catalogue()
	_booth.aim(view)
	return await _booth.take()


## The radius at which the mean over a circle first has a minimum.
func _first_dark_ring(picture: Image, centre: Vector2, channel: int, scale: float) -> float:
	var darkest := INF
	var found := 0.0
	var radius := 2.0 * scale
	while radius < 5.0 * scale:
		var light := _mean_on_circle(picture, centre, radius, channel)
		if light < darkest:
			darkest = light
			found = radius
		radius += 0.02 * scale
	return found


func _judge_profile(picture: Image, centre: Vector2, channel: int, scale: float) -> void:
	# Bilinear reading rounds the peak off; the flank at half the way is a better unit.
	var unit := _mean_on_circle(picture, centre, 1.2 * scale, channel) / AiryPattern.brightness(1.2)
	for x: float in [0.6, 1.6, 2.4, 3.0]:
		var light := _mean_on_circle(picture, centre, x * scale, channel) / unit
		assert_almost_eq(
			light, AiryPattern.brightness(x), 0.02, "channel %s, x = %s" % [channel, x]
		)
	var ring := _mean_on_circle(picture, centre, AiryPattern.FIRST_RING * scale, channel) / unit
	assert_almost_eq(ring, AiryPattern.RING_BRIGHTNESS, 0.15 * AiryPattern.RING_BRIGHTNESS, "ring")


func _mean_on_circle(picture: Image, centre: Vector2, radius: float, channel: int) -> float:
	var sum := 0.0
	for step in 64:
		var place := centre + Vector2.from_angle(TAU * step / 64.0) * radius - Vector2(0.5, 0.5)
		var corner := Vector2i(place.floor())
		var part := place - Vector2(corner)
		var upper := lerpf(
			PicturePatch.colour(picture, corner)[channel],
			PicturePatch.colour(picture, corner + Vector2i(1, 0))[channel],
			part.x
		)
		var lower := lerpf(
			PicturePatch.colour(picture, corner + Vector2i(0, 1))[channel],
			PicturePatch.colour(picture, corner + Vector2i(1, 1))[channel],
			part.x
		)
		sum += lerpf(upper, lower, part.y)
	return sum / 64.0


## How many pixels to the right of the middle one have light.
func _reach(picture: Image) -> int:
	var reach := 0
	while PicturePatch.colour(picture, Vector2i(640 + reach, 360)) != Vector3.ZERO:
		reach += 1
	return reach
