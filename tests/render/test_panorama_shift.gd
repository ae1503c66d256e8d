# SPDX-License-Identifier: MIT
extends GutTest
## A panorama's light is shifted in frequency as that of black bodies of its colour.

const KELVINS: PackedFloat64Array = [3000.0, 5772.0, 9000.0]
## Of luminance: the colour gives the temperature to 3 %, and the eye's limits make more of that.
const TOLERANCE: float = 0.2
const COLOUR_TOLERANCE: float = 0.05

var _booth: SkyBooth

@warning_ignore("untyped_declaration")
func should_skip_script():
	return RendererScope.mobile_alone()


func before_all() -> void:
	_booth = SkyBooth.new()
	_booth.sky.stars_visible = false
	_booth.sky.background = BlackHoleSky.BACKGROUND_PANORAMA
	add_child(_booth)


func after_all() -> void:
	_booth.free()


func test_uniform_sky_of_a_black_body(
	p: Array = use_parameters(
		[
			[LensingTable.MOTION_STATIC, 1.4],
			[LensingTable.MOTION_RAIN, 3.0],
			[LensingTable.MOTION_RAIN, 0.8]
		]
	)
) -> void:
	if not SkyBooth.is_linear():
		pending("Compatibility clips at white")
		return
	for kelvin: float in KELVINS:
		_booth.sky.panorama = _even(PlanckLight.colour(kelvin) * 0.01)
		var view := ExactView.new(Vector3(0.0, 0.6, 0.8) * float(p[1]), p[0])
		for beside: float in [0.3, 1.2]:
			view.look_beside(view.shadow_half_angle() + beside, Vector3.UP)
			var ray: Dictionary = view.observer.trace(view.place, Vec3D.to_vector3(view.forward))
			var g: float = ray["redshift"]
			if g * kelvin < 1900.0:
				continue
			_booth.aim(view)
			var seen := PicturePatch.colour(await _booth.take(), Vector2i(640, 360))
			var expected := (
				PlanckLight.colour(g * kelvin) * (0.01 * PlanckLight.shift_factor(kelvin, g))
			)
			var whose := "%s K, g = %.3f" % [kelvin, g]
			assert_almost_eq(_grey(seen) / _grey(expected), 1.0, TOLERANCE, whose)
			var colour := seen / _grey(seen) - expected / _grey(expected)
			assert_lt(colour.abs()[colour.abs().max_axis_index()], COLOUR_TOLERANCE, whose)


func test_no_tint_is_left_of_a_large_shift() -> void:
	if not SkyBooth.is_linear():
		pending("Compatibility clips at white")
		return
	var kelvin := 9000.0
	# Greener than any black body.
	_booth.sky.panorama = _even(PlanckLight.colour(kelvin) * Vector3(0.01, 0.015, 0.01))
	var view := ExactView.new(Vector3(0, 0, 0.8), LensingTable.MOTION_RAIN)
	view.look_beside(3.0, Vector3.UP)
	var ray: Dictionary = view.observer.trace(view.place, Vec3D.to_vector3(view.forward))
	var g: float = ray["redshift"]
	assert_lt(g, 0.5)
	_booth.aim(view)
	var seen := PicturePatch.colour(await _booth.take(), Vector2i(640, 360))
	var expected := PlanckLight.colour(g * kelvin)
	var colour := seen / _grey(seen) - expected / _grey(expected)
	assert_lt(colour.abs()[colour.abs().max_axis_index()], COLOUR_TOLERANCE)


func test_a_chart_keeps_its_colours() -> void:
	_booth.sky.panorama_is_light = false
	_booth.sky.panorama = _even(Vector3(0.2, 0.3, 0.1))
	var view := ExactView.new(Vector3(0, 0, 1.4), LensingTable.MOTION_STATIC)
	view.look_beside(view.shadow_half_angle() + 1.0, Vector3.UP)
	_booth.aim(view)
	var seen := PicturePatch.colour(await _booth.take(), Vector2i(640, 360))
	assert_almost_eq(seen, Vector3(0.2, 0.3, 0.1), Vector3.ONE * _step())
	_booth.sky.panorama_is_light = true


func test_saturation_changes_colour_and_not_luminance(
	p: Array = use_parameters([[0.0, 0.0], [1.0, 1.0], [1.5, 1.5]])
) -> void:
	_booth.sky.saturation = p[0]
	_booth.sky.panorama_is_light = false
	var colour := Vector3(0.2, 0.15, 0.12)
	_booth.sky.panorama = _even(colour)
	var view := ExactView.new(Vector3(0, 0, 4), LensingTable.MOTION_STATIC)
	view.look_beside(2.5, Vector3.UP)
	_booth.aim(view)
	var seen := PicturePatch.colour(await _booth.take(), Vector2i(640, 360))
	_booth.sky.saturation = 1.0
	_booth.sky.panorama_is_light = true
	var grey := Vector3.ONE * _grey(colour)
	assert_almost_eq(seen, grey + (colour - grey) * float(p[1]), Vector3.ONE * _step())


static func _grey(colour: Vector3) -> float:
	return colour.dot(Vector3(0.2126, 0.7152, 0.0722))


static func _even(colour: Vector3) -> ImageTexture:
	var image := Image.create(16, 8, true, Image.FORMAT_RGBF)
	image.fill(Color(colour.x, colour.y, colour.z))
	image.generate_mipmaps()
	return ImageTexture.create_from_image(image)


## What colours are told apart by: half floats, or the 8 bits of Compatibility.
static func _step() -> float:
	return 1e-3 if SkyBooth.is_linear() else 0.004
