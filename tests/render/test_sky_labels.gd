# SPDX-License-Identifier: MIT
extends GutTest
## Labels stand beside the images that they name.

const PLACE := Vector3(1.0, -2.0, 4.0)

var _booth: SkyBooth
var _rng := RandomNumberGenerator.new()


func before_all() -> void:
	_booth = SkyBooth.new()
	_booth.sky.stars_visible = false
	add_child(_booth)


func after_all() -> void:
	_booth.free()


func test_images_are_projected_where_they_are(
	motion: LensingTable.Motion = use_parameters(
		[LensingTable.MOTION_STATIC, LensingTable.MOTION_RAIN, LensingTable.MOTION_ORBIT]
	)
) -> void:
	_rng.seed = 8
	var view := ExactView.new(PLACE, motion)
	view.observer.axis = Vector3(1.0, 0.2, 0.0)
	view.vertical_fov_deg = 80.0
	_booth.aim(view)
	var compared := 0
	for i in 400:
		var star := Vector3(_rng.randfn(), _rng.randfn(), _rng.randfn()).normalized()
		var order := i % 2
		var pixel := view.star_spot(star, order).pixel
		if pixel == ExactView.NOWHERE or not view.holds(pixel, 0.0):
			continue
		compared += 1
		var found := _booth.sky.project_image(_booth.camera, star, order)
		assert_lt(found.distance_to(pixel), 0.05)
	assert_gt(compared, 60)


func test_what_is_not_drawn_is_nowhere() -> void:
	var view := ExactView.new(PLACE, LensingTable.MOTION_STATIC)
	_booth.aim(view)
	_booth.sky.image_orders = 1
	for found: Vector2 in [
		_booth.sky.project_image(_booth.camera, PLACE, 0),
		_booth.sky.project_image(_booth.camera, -PLACE + Vector3(1, 0, 0), 1),
		_booth.sky.project_image(_booth.camera, Vector3.ZERO, 0),
		_booth.sky.project_image(null, Vector3.UP, 0),
	]:
		assert_false(found.is_finite())
	_booth.sky.image_orders = 4


func test_names_are_written_and_do_not_overlap() -> void:
	var labels := SkyLabels.new()
	labels.sky = _booth.sky
	labels.camera = _booth.camera
	labels.constellations_shown = true
	labels.faintest = 4.0
	_booth.viewport.add_child(labels)
	var view := ExactView.new(PLACE, LensingTable.MOTION_STATIC)
	view.vertical_fov_deg = 100.0
	_booth.aim(view)
	var written := PictureMeasure.of_image(await _booth.take())
	labels.visible = false
	var without := PictureMeasure.of_image(await _booth.take())
	labels.free()
	var lit := 0
	for i in written.luminance.size():
		lit += 1 if written.luminance[i] > without.luminance[i] + 0.1 else 0
	assert_between(lit, 1000, 60000, "of the addon's own tables")
