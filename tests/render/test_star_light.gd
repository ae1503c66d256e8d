# SPDX-License-Identifier: MIT
extends GutTest
## The light of a lone star, summed over its image, is what the radiometric scale says: magnitude,
## magnification, shifted Planck spectrum and pixel size, whatever the sprite's width.

const TOLERANCE: float = 0.02
const STATIC := LensingTable.MOTION_STATIC
const RAIN := LensingTable.MOTION_RAIN

var _booth: SkyBooth
var _rng := RandomNumberGenerator.new()


func before_all() -> void:
	_booth = SkyBooth.new()
	add_child(_booth)


func after_all() -> void:
	_booth.free()


func before_each() -> void:
	_rng.seed = 3
	_booth.sky.psf_sigma = 1.0
	_booth.sky.exposure = 0.0


func test_widths_of_the_sprite(sigma: float = use_parameters([0.7, 1.0, 1.5, 2.0, 3.0])) -> void:
	_booth.sky.psf_sigma = sigma
	var view := ExactView.new(Vector3(3, 2, -4), STATIC)
	view.look_beside(0.8, Vector3(1, 2, 0.5))
	var field := StarField.new(view, _rng, 2.0 * sigma * sigma, 14.0 * sigma)
	field.add(0, 12)
	field.add(1, 4)
	await _judge(view, field, 12, "sigma %s px" % sigma)


func test_on_and_off_pixel_centres(sigma: float = use_parameters([0.7, 1.0, 3.0])) -> void:
	_booth.sky.psf_sigma = sigma
	var view := ExactView.new(Vector3(3, 2, -4), STATIC)
	view.look_beside(0.8, Vector3(1, 2, 0.5))
	var field := StarField.new(view, _rng, 2.0 * sigma * sigma, 14.0 * sigma)
	for row in 4:
		for column in 4:
			var offset := Vector2(0.5, 0.5) + 0.25 * Vector2(column, row)
			field.add_at(Vector2(200 + 240 * column, 120 + 150 * row) + offset)
	await _judge(view, field, 12, "sigma %s px" % sigma)


func test_resolutions_and_fields(
	p: Array = use_parameters(
		[[640, 360, 20.0], [300, 500, 100.0], [1920, 1080, 60.0], [500, 400, 4]]
	)
) -> void:
	var view := ExactView.new(Vector3(3, 2, -4), STATIC)
	view.size = Vector2i(p[0], p[1])
	view.vertical_fov_deg = p[2]
	view.look_beside(1.1, Vector3(1, 2, 0.5))
	var field := StarField.new(view, _rng, 2.0)
	field.add(0, 12)
	await _judge(view, field, 8, "%s" % [p])


func test_observers(
	p: Array = use_parameters([[STATIC, 1.2], [STATIC, 1e3], [RAIN, 3.0], [RAIN, 1.0], [RAIN, 0.3]])
) -> void:
	var view := ExactView.new(Vector3(-0.48, 0.64, 0.6) * p[1], p[0])
	view.look_beside(view.shadow_half_angle() + 0.2, Vector3(1, 2, 0.5))
	var field := StarField.new(view, _rng, 2.0)
	field.add(1, 5)
	field.add(0, 12)
	await _judge(view, field, 8, "%s" % [p])


func test_temperatures(kelvin: float = use_parameters([2500.0, 4000.0, 9000.0, 30000.0])) -> void:
	var view := ExactView.new(Vector3(0.5, 0.2, -1.2), STATIC)
	view.look_beside(1.6, Vector3(1, 2, 0.5))
	var field := StarField.new(view, _rng, 1.0)
	field.seen_kelvin = kelvin
	field.add(0, 12)
	await _judge(view, field, 8, "%s K" % kelvin)


func test_exposure_is_a_power_of_two() -> void:
	_booth.sky.exposure = 3.0
	var view := ExactView.new(Vector3(3, 2, -4), STATIC)
	view.look_beside(0.8, Vector3(1, 2, 0.5))
	var field := StarField.new(view, _rng, 0.25)
	field.add(0, 8)
	await _judge(view, field, 8, "+3 EV", 8.0)


func _judge(
	view: ExactView, field: StarField, enough: int, whose: String, factor: float = 1.0
) -> void:
	_booth.sky.catalogue = field.catalogue()
	_booth.aim(view)
	var picture: Image = await _booth.take()
	var radius := ceili(5.5 * _booth.sky.psf_sigma) + 1
	var worst := 0.0
	for target in field.targets:
		var light := PicturePatch.light(picture, target.pixel, radius)
		var off := light / (factor * target.sum) - 1.0
		worst = off if not absf(off) <= absf(worst) else worst
	gut.p("%s: %d stars, worst %.3f %%" % [whose, field.targets.size(), 100.0 * worst])
	assert_gte(field.targets.size(), enough, "%s: stars measured" % whose)
	assert_almost_eq(worst, 0.0, TOLERANCE, "%s: light against the formula" % whose)
