# SPDX-License-Identifier: MIT
extends GutTest
## What the properties of BlackHoleSky do to the picture, and that changes show in the very next
## frame.

const STATIC := LensingTable.MOTION_STATIC
const TOLERANCE_PX: float = 0.08

var _booth: SkyBooth
var _view: ExactView
var _field: StarField

@warning_ignore("untyped_declaration")
func should_skip_script():
	return RendererScope.without_forward_plus()


func before_each() -> void:
	_booth = SkyBooth.new()
	add_child_autofree(_booth)
	var rng := RandomNumberGenerator.new()
	rng.seed = 5
	_view = ExactView.new(Vector3(3, 2, -4), STATIC)
	_view.look_beside(_view.shadow_half_angle() + 0.3, Vector3(1, 2, 0.5))
	_field = StarField.new(_view, rng, 1.5)
	_field.add(1, 6)
	_field.add(0, 8)
	_booth.sky.catalogue = _field.catalogue()
	_booth.aim(_view)
	await _booth.take()


func test_rotating_the_node_turns_the_sky() -> void:
	var turn := Basis.from_euler(Vector3(0.3, 1.1, -0.7))
	var turned := StarField.new(_view, null)
	turned.magnitudes = _field.magnitudes
	turned.temperatures = _field.temperatures
	for star in _field.directions:
		turned.directions.append(turn.inverse() * star)
	_booth.sky.catalogue = turned.catalogue()
	_booth.sky.basis = turn
	_expect_stars(await _booth.take(), "turned there and back")


func test_the_hole_is_where_the_node_is() -> void:
	_booth.sky.position = Vector3(5, -2, 30)
	_booth.camera.transform = _view.camera_transform(1.0, _booth.sky.position)
	_expect_stars(await _booth.take(), "moved together")


func test_the_radius_is_the_unit_of_length() -> void:
	_booth.aim(_view, 25.0)
	_expect_stars(await _booth.take(), "25 m")


func test_parents_move_the_node() -> void:
	var parent := Node3D.new()
	_booth.viewport.add_child(parent)
	_booth.sky.reparent(parent)
	parent.position = Vector3(0, 7, 0)
	_booth.camera.transform = _view.camera_transform(1.0, parent.position)
	_expect_stars(await _booth.take(), "moved by its parent")


func test_without_lensing_the_sky_is_flat() -> void:
	_booth.sky.lensing = 0.0
	_expect_flat(await _booth.take())


func test_without_a_table_the_sky_is_flat_until_there_is_one() -> void:
	var table := _booth.sky.table
	_booth.sky.table = null
	_expect_flat(await _booth.take())
	_booth.sky.table = LensingTable.new()
	_expect_flat(await _booth.take())
	_booth.sky.table.load_file(SkyBooth.TABLE_FILE)
	_expect_stars(await _booth.take(), "table loaded")
	_booth.sky.table = table
	_expect_stars(await _booth.take(), "another table")


func test_half_lensing_is_half_the_hole() -> void:
	_booth.sky.lensing = 0.5
	_view.place *= 2.0  # in radii of the smaller hole; the camera stays
	var targets := _field.alone(_view)
	assert_gte(targets.size(), 3, "images to measure")
	_expect(await _booth.take(), targets, "half the hole")


func test_orders_of_images() -> void:
	_booth.sky.image_orders = 1
	var picture: Image = await _booth.take()
	for target in _field.targets:
		var light := PicturePatch.light(picture, target.pixel, 5)
		if target.order == 0:
			assert_almost_eq(light, target.sum, 0.05 * target.sum, "order 0 stays")
		else:
			assert_eq(light, 0.0, "order 1 goes")
	_booth.sky.image_orders = 2
	_expect_stars(await _booth.take(), "two orders")


func test_magnitude_limit() -> void:
	var limit := _booth.sky.catalogue.get_star_magnitude(6)
	_booth.sky.magnitude_limit = limit
	var picture: Image = await _booth.take()
	var shown := 0
	for i in _field.targets.size():
		var light := PicturePatch.light(picture, _field.targets[i].pixel, 5)
		if _field.magnitudes[i] <= limit:
			shown += 1
			assert_gt(light, 1.0, "a star within the limit")
		else:
			assert_eq(light, 0.0, "a star beyond the limit")
	assert_between(shown, 1, _field.targets.size() - 1)


func test_hiding() -> void:
	_booth.sky.background = BlackHoleSky.BACKGROUND_GRID
	_booth.sky.hide()
	assert_eq(await _total(), 0.0, "hidden")
	_booth.sky.show()
	assert_gt(await _total(), 10.0, "shown again")
	_booth.sky.background = BlackHoleSky.BACKGROUND_NONE
	_booth.sky.stars_visible = false
	assert_eq(await _total(), 0.0, "no stars, no background")
	_booth.sky.stars_visible = true
	_expect_stars(await _booth.take(), "shown again")


func test_changing_stars_in_place() -> void:
	var directions: PackedVector3Array = [_field.directions[0]]
	_booth.sky.catalogue.set_stars(directions, [_field.magnitudes[0]], [_field.temperatures[0]])
	var picture: Image = await _booth.take()
	assert_gt(PicturePatch.light(picture, _field.targets[0].pixel, 5), 1.0, "the star that stays")
	assert_eq(PicturePatch.light(picture, _field.targets[1].pixel, 5), 0.0, "a star that went")
	_booth.sky.catalogue = null
	assert_eq(await _total(), 0.0, "no catalogue, no stars")
	_booth.sky.catalogue = _field.catalogue()
	_expect_stars(await _booth.take(), "stars again")


func test_render_layers() -> void:
	_booth.sky.render_layers = 2
	_booth.camera.cull_mask = 1
	assert_eq(await _total(), 0.0, "the camera does not look at this layer")
	_booth.camera.cull_mask = 2
	_expect_stars(await _booth.take(), "the camera looks at this layer alone")


func test_leaving_and_entering_the_tree() -> void:
	_booth.viewport.remove_child(_booth.sky)
	assert_eq(await _total(), 0.0, "taken out")
	_booth.viewport.add_child(_booth.sky)
	_expect_stars(await _booth.take(), "put back")


func test_observer_motion() -> void:
	_booth.sky.observer_motion = LensingTable.MOTION_RAIN
	_view.observer.motion = LensingTable.MOTION_RAIN
	var targets := _field.alone(_view)
	assert_gte(targets.size(), 3, "images to measure")
	_expect(await _booth.take(), targets, "falling")


func test_orthographic_cameras_see_the_flat_sky_at_60_degrees() -> void:
	_booth.camera.projection = Camera3D.PROJECTION_ORTHOGONAL
	_expect_flat(await _booth.take())


func _total() -> float:
	var sum := 0.0
	for value in PictureMeasure.of_image(await _booth.take()).luminance:
		sum += value
	return sum


func _expect_stars(picture: Image, when: String) -> void:
	_expect(picture, _field.targets, when)


func _expect_flat(picture: Image) -> void:
	var targets: Array[StarField.Target] = []
	for i in _field.directions.size():
		var target := StarField.Target.new()
		target.pixel = _view.to_pixel(ExactView.doubled(_field.directions[i]))
		if target.pixel != ExactView.NOWHERE and _view.holds(target.pixel, 20.0):
			var flux := pow(10.0, -0.4 * _field.magnitudes[i])
			target.sum = flux * _view.flat_luminance_sum(target.pixel)
			targets.append(target)
	assert_gte(targets.size(), 2, "stars to measure on the flat sky")
	_expect(picture, targets, "flat")


func _expect(picture: Image, targets: Array[StarField.Target], when: String) -> void:
	for target in targets:
		var seen := PicturePatch.centroid(picture, target.pixel)
		assert_lt(seen.distance_to(target.pixel), TOLERANCE_PX, "%s: place" % when)
		if SkyBooth.is_linear() or target.sum < 3.0:
			var light := PicturePatch.light(picture, target.pixel, 6)
			assert_almost_eq(light, target.sum, 0.05 * target.sum, "%s: light" % when)
