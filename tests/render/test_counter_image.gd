# SPDX-License-Identifier: MIT
extends GutTest
## The second image of a star moves against the first when the eye moves sideways, and is mirrored.

var _booth: SkyBooth

@warning_ignore("untyped_declaration")
func should_skip_script():
	return RendererScope.without_forward_plus()


func before_all() -> void:
	_booth = SkyBooth.new()
	_booth.sky.image_orders = 2
	add_child(_booth)


func after_all() -> void:
	_booth.free()


func test_order_1_moves_against_order_0() -> void:
	# A star behind the hole, to its right; the eye moves up and keeps looking at the hole.
	var star := Vector3(0.3, 0.0, -1.0).normalized()
	var heights: PackedFloat64Array = [-0.4, -0.2, 0.0, 0.2, 0.4]
	var direct: PackedFloat64Array = []
	var counter: PackedFloat64Array = []
	for height in heights:
		var view := _view(Vector3(0.0, height, 10.0))
		var picture: Image = await _photograph(view, [star])
		direct.append(_place(picture, view, star, 0).y)
		counter.append(_place(picture, view, star, 1).y)
	gut.p("order 0 at y = %s, order 1 at y = %s" % [direct, counter])
	for i in heights.size() - 1:
		var moved := direct[i + 1] - direct[i]
		var moved_against := counter[i + 1] - counter[i]
		assert_gt(absf(moved), 1.0, "order 0 moves")
		assert_gt(absf(moved_against), 1.0, "order 1 moves")
		assert_eq(signf(moved), -signf(moved_against), "order 1 moves the other way")


func test_order_1_is_mirrored() -> void:
	var stars: Array[Vector3] = [
		Vector3(0.30, 0.02, -1.0).normalized(),
		Vector3(0.45, 0.05, -1.0).normalized(),
		Vector3(0.33, 0.20, -1.0).normalized(),
	]
	var view := _view(Vector3(0.0, 0.0, 10.0))
	var picture: Image = await _photograph(view, stars)
	var flat: PackedVector2Array = []
	var direct: PackedVector2Array = []
	var mirrored: PackedVector2Array = []
	for star in stars:
		flat.append(view.to_pixel(ExactView.doubled(star)))
		direct.append(_place(picture, view, star, 0))
		mirrored.append(_place(picture, view, star, 1))
	var sense := signf(_area(flat))
	gut.p("areas %s %s %s" % [_area(flat), _area(direct), _area(mirrored)])
	assert_gt(sense * _area(direct), 20.0, "order 0 keeps the sense of the triangle")
	assert_lt(sense * _area(mirrored), -20.0, "order 1 turns it over")
	for pixel in mirrored:
		assert_lt(pixel.x, 640.0, "order 1 stands on the other side of the hole")


## Looks at the hole; up is world up.
func _view(place: Vector3) -> ExactView:
	var view := ExactView.new(place, LensingTable.MOTION_STATIC)
	view.look_along(ExactView.doubled(-place), Vector3.UP)
	return view


func _photograph(view: ExactView, stars: Array[Vector3]) -> Image:
	var magnitudes := PackedFloat32Array()
	for star in stars:
		# So bright that the fainter image, order 1, gets a sum of 1.
		var light := view.luminance_sum(view.star_spot(star, 1), StarField.WHITE_KELVIN)
		magnitudes.append(2.5 * log(light) / log(10.0))
	var kelvins := PackedFloat32Array()
	kelvins.resize(stars.size())
	kelvins.fill(StarField.WHITE_KELVIN)
	_booth.show_stars(PackedVector3Array(stars), magnitudes, kelvins)
	_booth.aim(view)
	return await _booth.take()


func _place(picture: Image, view: ExactView, star: Vector3, order: int) -> Vector2:
	var expected := view.star_spot(star, order).pixel
	var seen := PicturePatch.centroid(picture, expected)
	assert_lt(seen.distance_to(expected), 0.08, "order %d stands at its place" % order)
	return seen


func _area(corners: PackedVector2Array) -> float:
	return 0.5 * (corners[1] - corners[0]).cross(corners[2] - corners[0])
