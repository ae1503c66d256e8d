# SPDX-License-Identifier: MIT
extends GutTest
## Each effect can be switched off alone: what a picture shows then is the exact chain flat sky,
## static observer, moving observer without that link. And the shaders for the usual case show
## what the general ones show.

const PLACE := Vector3(2.4, -1.2, 2.8)
const STAR_KELVIN: float = 5800.0

var _booth: SkyBooth
var _moving := SkyObserver.new()
var _static := SkyObserver.new()
var _star := Vector3(-0.55, 0.75, 0.2).normalized()
var _cases: Array = ["none", "aberration", "gravitational_shift", "doppler", "magnification"]

@warning_ignore("untyped_declaration")
func should_skip_script():
	return RendererScope.mobile_alone()


func before_all() -> void:
	_booth = SkyBooth.new()
	add_child(_booth)
	_moving.motion = LensingTable.MOTION_ORBIT
	_moving.axis = Vector3(0.3, 1.0, 0.4)


func after_all() -> void:
	_booth.free()


func before_each() -> void:
	for effect: String in _cases.slice(1):
		_booth.sky.set("effect_" + effect, true)
	_booth.sky.effect_deflection = true
	_booth.sky.effect_higher_orders = true
	_booth.sky.image_orders = 1
	_booth.sky.background = BlackHoleSky.BACKGROUND_NONE
	_booth.sky.stars_visible = true


func test_one_effect_off(off: String = use_parameters(_cases)) -> void:
	var moving := _moving.star_image(PLACE, _star, 0)
	var still := _static.star_image(PLACE, _star, 0)
	var shown := still if off == "aberration" else moving
	var g: float = moving["redshift"]
	if off == "gravitational_shift":
		g /= still["redshift"]
	elif off == "doppler":
		g = still["redshift"]
	var mu: float = 1.0 if off == "magnification" else float(shown["magnification"])
	await _judge(off, shown["direction"], mu * PlanckLight.shift_factor(STAR_KELVIN, g))


func test_no_deflection_is_special_relativity() -> void:
	# From the static frame, where the star is where it is, into the moving one by way of rain.
	var in_rain := _boosted(_star, -_static.celerity_at(PLACE))
	var seen := _boosted(in_rain, _moving.celerity_at(PLACE))
	var doppler := (
		_doppler(in_rain, _moving.celerity_at(PLACE))
		/ _doppler(in_rain, _static.celerity_at(PLACE))
	)
	var g := doppler / sqrt(1.0 - 1.0 / PLACE.length())
	await _judge("deflection", seen, PlanckLight.shift_factor(STAR_KELVIN, g) / pow(doppler, 2))


func test_without_higher_orders_there_is_one_image() -> void:
	_booth.sky.image_orders = 3
	var view := ExactView.new(PLACE, LensingTable.MOTION_STATIC)
	view.vertical_fov_deg = 120.0
	_show_star(0.02)
	view.look_along(ExactView.doubled(-PLACE), Vector3.UP)
	var second := view.star_spot(_star, 1).pixel
	for shown: bool in [true, false]:
		_booth.sky.effect_higher_orders = shown
		_booth.aim(view)
		var light := PicturePatch.light(await _booth.take(), second, 3)
		if shown:
			assert_gt(light, 0.01)
		else:
			assert_eq(light, 0.0)


func test_inside_the_horizon_effects_go_in_pairs() -> void:
	_booth.sky.background = BlackHoleSky.BACKGROUND_GRID
	var view := ExactView.new(PLACE * 0.15, LensingTable.MOTION_RAIN)
	view.look_beside(view.shadow_half_angle() + 0.2, Vector3.UP)
	_booth.aim(view)
	var whole := await _picture()
	_booth.sky.effect_aberration = false
	assert_lt(_unlike(whole, await _picture()), 0.01, "deflection alone stands for both")
	_booth.sky.effect_deflection = false
	assert_gt(_unlike(whole, await _picture()), 0.05, "without either the sky is flat")


## Zero celerity relative to rain or to the static observer: the general shaders' way to what the
## quick ones show.
func test_quick_and_general_shaders_agree(
	motion: LensingTable.Motion = use_parameters(
		[LensingTable.MOTION_STATIC, LensingTable.MOTION_RAIN]
	)
) -> void:
	_booth.sky.catalogue = StarCatalogue.new()
	_booth.sky.catalogue.load_file(SkyBooth.CATALOGUE_FILE)
	_booth.sky.image_orders = 3
	_booth.sky.panorama = load(MilkyWay.FILE)
	_booth.sky.panorama_luminance = MilkyWay.LUMINANCE
	_booth.sky.background = BlackHoleSky.BACKGROUND_PANORAMA
	var view := ExactView.new(PLACE, motion)
	_booth.aim(view)
	var quick := await _picture()
	view.observer = SkyObserver.new()
	view.observer.motion = LensingTable.MOTION_VELOCITY
	view.observer.relative_to_static = motion == LensingTable.MOTION_STATIC
	_booth.aim(view)
	assert_lt(_unlike(quick, await _picture()), 0.01)


func test_flight_without_a_hole() -> void:
	_booth.sky.lensing = 0.0
	var view := ExactView.new(PLACE, LensingTable.MOTION_VELOCITY)
	view.observer.celerity = SkyObserver.celerity_from_velocity(Vector3(0.5, 0.6, -0.4))
	var doppler := _doppler(_star, view.observer.celerity)
	var seen := _boosted(_star, view.observer.celerity)
	_show_star(1.0)
	view.look_along(ExactView.doubled(seen + Vector3(0.05, 0.1, 0.02)), Vector3.UP)
	_booth.aim(view)
	await _measure(
		view, seen, PlanckLight.shift_factor(STAR_KELVIN, doppler) / pow(doppler, 2), "flight"
	)
	_booth.sky.lensing = 1.0


func _judge(off: String, seen: Vector3, factor: float) -> void:
	if off != "none":
		_booth.sky.set("effect_" + off, false)
	var view := ExactView.new(PLACE, LensingTable.MOTION_STATIC)
	view.observer = _moving
	view.look_along(ExactView.doubled(seen + Vector3(0.05, 0.1, 0.02)), Vector3.UP)
	_show_star(factor)
	_booth.aim(view)
	await _measure(view, seen, 1.0, off + " off")


func _measure(view: ExactView, seen: Vector3, factor: float, whose: String) -> void:
	var picture: Image = await _booth.take()
	var pixel := view.to_pixel(ExactView.doubled(seen))
	var off := PicturePatch.centroid(picture, pixel).distance_to(pixel)
	assert_lt(off, 0.05 if SkyBooth.is_linear() else 0.08, whose + ": place")
	if SkyBooth.is_linear():
		var expected := view.flat_luminance_sum(pixel) * factor / ExactView.STAR_GAIN
		assert_almost_eq(
			PicturePatch.light(picture, pixel, 7) / expected, 1.0, 0.02, whose + ": light"
		)


## Shows the star alone, so bright that an image brightened by `factor` has the light 1.
func _show_star(factor: float) -> void:
	var magnitude := 2.5 * log(factor * ExactView.STAR_GAIN) / log(10.0)
	_booth.show_stars([_star], [magnitude], [STAR_KELVIN])


func _picture() -> PictureMeasure:
	return PictureMeasure.of_image(await _booth.take())


## Mean difference of two pictures' luminance in units of the mean.
static func _unlike(a: PictureMeasure, b: PictureMeasure) -> float:
	var sum := 0.0
	var light := 0.0
	for i in a.luminance.size():
		sum += absf(a.luminance[i] - b.luminance[i])
		light += a.luminance[i]
	return sum / light


static func _doppler(direction: Vector3, celerity: Vector3) -> float:
	return sqrt(1.0 + celerity.length_squared()) + celerity.dot(direction)


static func _boosted(direction: Vector3, celerity: Vector3) -> Vector3:
	var gamma := sqrt(1.0 + celerity.length_squared())
	return (direction + celerity * (1.0 + celerity.dot(direction) / (1.0 + gamma))).normalized()
