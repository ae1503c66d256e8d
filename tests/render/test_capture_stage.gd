# SPDX-License-Identifier: MIT
extends GutTest
## Captures from end to end: shot in JSON's terms, catalogue from CSV, stage, picture, encoding.

const FOLDER: String = "user://capture_stage_test"

var _stage: ShotStage

@warning_ignore("untyped_declaration")
func should_skip_script():
	return RendererScope.mobile_alone()


func before_all() -> void:
	DirAccess.make_dir_recursive_absolute(FOLDER)


func before_each() -> void:
	_stage = ShotStage.new()
	add_child_autofree(_stage)


func after_all() -> void:
	for file in DirAccess.get_files_at(FOLDER):
		DirAccess.remove_absolute(FOLDER.path_join(file))
	DirAccess.remove_absolute(FOLDER)


func test_stars_of_a_csv_file(lensing: bool = use_parameters([true, false])) -> void:
	var view := ExactView.new(Vector3(3, 2, -4), LensingTable.MOTION_STATIC)
	view.look_along(ExactView.doubled(Vector3(1.2, 1.5, 3.0)), Vector3.UP)
	var field := StarField.new(view, _dice(), 1.5)
	field.add(0, 10)
	field.add(1, 4)
	var spec := _spec(
		{
			"position_rs": [3, 2, -4],
			"look_at_rs": [4.2, 3.5, -1.0],
			"stars":
			{
				"catalogue": _csv("stars.csv", field),
				"magnitude_limit": 99,
				"orders": 4,
				"lensing": lensing,
			},
		}
	)
	var picture := await _take(spec)
	var targets := field.targets if lensing else _flat(view, field)
	assert_gte(targets.size(), 4, "stars to measure")
	for target in targets:
		var seen := PicturePatch.centroid(picture, target.pixel)
		assert_lt(seen.distance_to(target.pixel), 0.08, "place")
		var light := PicturePatch.light(picture, target.pixel, 7)
		assert_almost_eq(light, target.sum, 0.02 * target.sum, "light")


func test_light_survives_the_exr_file() -> void:
	if not SkyBooth.is_linear():
		pending("the Compatibility renderer has no linear light to write")
		return
	var view := ExactView.new(Vector3(3, 2, -4), LensingTable.MOTION_STATIC)
	view.look_along(ExactView.doubled(Vector3(1.2, 1.5, 3.0)), Vector3.UP)
	var field := StarField.new(view, _dice(), 40.0, 30.0)
	field.add(0, 8)
	var stars := {
		"catalogue": _csv("bright.csv", field), "magnitude_limit": 99, "psf_sigma_px": 2.0
	}
	var data := {"position_rs": [3, 2, -4], "look_at_rs": [4.2, 3.5, -1.0], "stars": stars}
	var picture := await _take(_spec(data))
	assert_eq(picture.save_exr(FOLDER.path_join("light.exr")), OK)
	var read := Image.load_from_file(FOLDER.path_join("light.exr"))
	assert_gte(field.targets.size(), 4, "stars to measure")
	for target in field.targets:
		var light := PicturePatch.light(read, target.pixel, 12)
		assert_almost_eq(light, target.sum, 0.02 * target.sum, "light brighter than white")


func test_narrow_field_far_away() -> void:
	var view := ExactView.new(Vector3(0, 6000, 8000), LensingTable.MOTION_RAIN)
	view.vertical_fov_deg = 0.3
	view.look_along(ExactView.doubled(-view.place), Vector3(1, 0, 0))
	var field := StarField.new(view, _dice(), 1.5)
	field.add(1, 6)
	var spec := _spec(
		{
			"position_rs": [0, 6000, 8000],
			"aim": "apparent",
			"up": [1, 0, 0],
			"vertical_fov_deg": 0.3,
			"observer": "rain",
			"stars": {"catalogue": _csv("far.csv", field), "magnitude_limit": 99, "orders": 2},
		}
	)
	var picture := await _take(spec)
	assert_gte(field.targets.size(), 3, "stars to measure")
	for target in field.targets:
		var seen := PicturePatch.centroid(picture, target.pixel)
		assert_lt(seen.distance_to(target.pixel), 0.1, "place")


func test_panorama_from_a_file_and_the_exact_curve() -> void:
	var image := Image.create_empty(64, 32, false, Image.FORMAT_RGBF)
	image.fill(Color(0.5, 0.1, 0.002))
	image.save_exr(FOLDER.path_join("even.exr"))
	var data := {
		# So far out that no shift shows.
		"position_rs": [0, 0, 1e6],
		"look_at_rs": [0, 0, 2e6],
		"resolution": [64, 48],
		"stars": null,
		"background": FOLDER.path_join("even.exr"),
	}
	var encoder := DisplayEncoder.new()
	add_child_autofree(encoder)
	var shown: Image = await encoder.encode(await _take(_spec(data)))
	assert_eq(shown.get_size(), Vector2i(64, 48))
	assert_eq(shown.get_format(), Image.FORMAT_RGB8)
	for pixel: Vector2i in [Vector2i(0, 0), Vector2i(32, 24), Vector2i(63, 47)]:
		var colour := shown.get_pixelv(pixel)
		# 255 times the sRGB curve: 1.055 x^(1/2.4) - 0.055, and 12.92 x below 0.0031308.
		assert_almost_eq(colour.r8, 188, 1)
		assert_almost_eq(colour.g8, 89, 1)
		assert_almost_eq(colour.b8, 7, 1)


func test_the_shadow_stays_black() -> void:
	var data := {
		"position_rs": [0, 0, 4], "resolution": [64, 48], "background": "grid", "stars": null
	}
	var picture := await _take(_spec(data))
	assert_eq(PicturePatch.light(picture, Vector2(32, 24), 2), 0.0, "the middle of the hole")
	assert_gt(PicturePatch.light(picture, Vector2(32, 24), 24), 0.1, "the sky round it")


func test_a_file_that_is_no_picture_is_refused() -> void:
	var path := FOLDER.path_join("broken.exr")
	var file := FileAccess.open(path, FileAccess.WRITE)
	file.store_string("no picture")
	file.close()
	var refusal: PackedStringArray = []
	var spec := _spec({"position_rs": [0, 0, 4], "background": path})
	assert_null(await _stage.take(spec, refusal))
	assert_string_contains(refusal[0], "broken.exr")


func _spec(data: Dictionary) -> ShotSpec:
	var spec := ShotSpec.from_data(data)
	assert_eq(spec.error, "", "the shot is fine")
	return spec


func _take(spec: ShotSpec) -> Image:
	var refusal: PackedStringArray = []
	var picture: Image = await _stage.take(spec, refusal)
	assert_eq(refusal, PackedStringArray(), "the shot is taken")
	return picture


func _dice() -> RandomNumberGenerator:
	var rng := RandomNumberGenerator.new()
	rng.seed = 13
	return rng


func _flat(view: ExactView, field: StarField) -> Array[StarField.Target]:
	var targets: Array[StarField.Target] = []
	for i in field.directions.size():
		var target := StarField.Target.new()
		target.pixel = view.to_pixel(ExactView.doubled(field.directions[i]))
		if target.pixel != ExactView.NOWHERE and view.holds(target.pixel, 20.0):
			target.sum = view.flat_luminance_sum(target.pixel) * pow(10, -0.4 * field.magnitudes[i])
			targets.append(target)
	return targets


func _csv(file_name: String, field: StarField) -> String:
	var path := FOLDER.path_join(file_name)
	var file := FileAccess.open(path, FileAccess.WRITE)
	file.store_string(StarCsv.text(field.directions, field.magnitudes, field.temperatures))
	file.close()
	return path
