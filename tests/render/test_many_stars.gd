# SPDX-License-Identifier: MIT
extends GutTest
## Large catalogues: the memory they take, and that no image is missing where buffers had to grow.

const STARS: int = 200000
const MANY_STARS: int = 2500000
const MOST_BYTES_PER_STAR: float = 64.0
const BYTES_IN_FULL: int = 48
const OUTWARD := Vector3(0.36, -0.48, 0.8)
## On the way to the hole, in its radii.
const PLACES: Array[float] = [300.0, 30.0, 8.0, 4.0, 2.0, 1.3]
## Pictures of the same stars may still differ by how half floats, or 8 bits, are rounded.
const TOLERANCE: float = 0.03
const TOLERANCE_8_BIT: float = 2.5 / 255.0

var _folder := ScratchFolder.new("many_stars")
var _stars := StarCatalogue.new()

@warning_ignore("untyped_declaration")
func should_skip_script():
	return RendererScope.mobile_alone()


func before_all() -> void:
	_stars.load_file(SyntheticStars.write(_folder, STARS))


func test_an_eye_that_nears_the_hole_sees_every_image() -> void:
	if _is_left_for_all():
		return
	assert_eq(_stars.get_star_count(), STARS)
	var booth := _booth()
	var bytes := PackedInt64Array()
	for r in PLACES:
		booth.aim(_view(r))
		var grown := await booth.take()
		bytes.append(booth.sky.get_star_buffer_bytes())
		if r != PLACES[0] and r != PLACES[-1] and r != 4.0:
			continue
		# As it should be: by a sky that has seen no other place.
		var fresh := _booth()
		fresh.aim(_view(r))
		var different := _different_pixels(grown, await fresh.take())
		assert_eq(different, 0, "pixels at %s" % r)
		fresh.free()
	# And to one that jumps.
	var jumped := _booth()
	for r: float in [PLACES[0], 2.0, 10.0, 3.0]:
		jumped.aim(_view(r))
		await jumped.take()
		bytes.append(jumped.sky.get_star_buffer_bytes())
	gut.p("%s bytes" % bytes)
	assert_gt(bytes[2], bytes[0] + STARS, "buffers grow where images grow many")
	for i in bytes.size():
		assert_gt(
			bytes[i], BYTES_IN_FULL * STARS, "the first images' are whole, and others are seen"
		)
		assert_lt(bytes[i], roundi(MOST_BYTES_PER_STAR * STARS), "place %d" % i)


func test_effects_that_allow_no_choice_cost_no_memory() -> void:
	if _is_left_for_all():
		return
	var booth := _booth()
	booth.sky.effect_magnification = false
	booth.aim(_view(4.0))
	await booth.take()
	assert_eq(booth.sky.get_star_buffer_bytes(), BYTES_IN_FULL * STARS, "all share one buffer")
	booth.sky.effect_magnification = true
	var again := await booth.take()
	var fresh := _booth()
	fresh.aim(_view(4.0))
	assert_eq(_different_pixels(again, await fresh.take()), 0, "pixels when all effects are back")


func test_no_catalogue_takes_no_memory() -> void:
	var booth := _booth()
	booth.aim(_view(4.0))
	await booth.take()
	booth.sky.catalogue = null
	assert_eq(booth.sky.get_star_buffer_bytes(), 0)


func test_millions_of_stars() -> void:
	if not RendererScope.is_everything_wanted():
		pending("2.5 million stars are drawn by ./test --all only")
		return
	if RenderingServer.get_current_rendering_method() != "mobile":
		pending("2.5 million stars are measured with one renderer only")
		return
	var stage := BenchStage.new()
	add_child_autofree(stage)
	assert_eq(stage.dress(null, 1.0), "")
	var figures := await ScaleTimes.measure(stage, SyntheticStars.write(_folder, MANY_STARS))
	gut.p(figures)
	assert_lt(_figure(figures, "stars_2500k_load_ms"), 1500.0)
	assert_lt(_figure(figures, "stars_2500k_bytes_per_star"), MOST_BYTES_PER_STAR)
	assert_lt(_figure(figures, "stars_2500k_to_linear"), 1.1)


func _is_left_for_all() -> bool:
	if not RendererScope.is_everything_wanted():
		pending("a long test, for ./test --all")
		return true
	return false


func _figure(figures: Dictionary, key: String) -> float:
	var value: float = figures[key]
	return value


func _booth() -> SkyBooth:
	var booth := SkyBooth.new()
	add_child_autofree(booth)
	booth.sky.catalogue = _stars
	return booth


func _view(r: float) -> ExactView:
	var view := ExactView.new(OUTWARD * r, LensingTable.MOTION_STATIC)
	view.look_beside(view.shadow_half_angle() + 0.2, Vector3.UP)
	return view


func _different_pixels(picture: Image, expected: Image) -> int:
	var linear := SkyBooth.is_linear()
	var count := 0
	var bright := 0
	for y in expected.get_height():
		for x in expected.get_width():
			var wanted := expected.get_pixel(x, y).get_luminance()
			var seen := picture.get_pixel(x, y).get_luminance()
			var limit := TOLERANCE * maxf(wanted, 0.05) if linear else TOLERANCE_8_BIT
			bright += 1 if wanted > 0.01 else 0
			count += 1 if absf(seen - wanted) > limit else 0
	assert_gt(bright, 200, "stars in the picture")
	return count
