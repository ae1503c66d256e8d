# SPDX-License-Identifier: MIT
extends GutTest
## The exact solution as scripts reach it: known numbers, reference vectors, refusals.

const STATIC := LensingTable.MOTION_STATIC
const RAIN := LensingTable.MOTION_RAIN
const REFERENCE: String = "res://gdextension/tests/data/"


func test_known_shadows() -> void:
	assert_almost_eq(rad_to_deg(LensingTable.shadow_angle(1.0, RAIN)), 84.2068977, 1e-7)
	assert_almost_eq(rad_to_deg(LensingTable.shadow_angle(1.5, STATIC)), 180.0, 1e-9)
	assert_almost_eq(rad_to_deg(LensingTable.shadow_angle(10.0, STATIC)), 2 * 14.2690273279, 1e-9)


func test_shadows_of_the_reference() -> void:
	var rows := _rows("shadow.csv")
	assert_gt(rows.size(), 100)
	for row in rows:
		var r := 1.0 / row[0]
		assert_almost_eq(0.5 * LensingTable.shadow_angle(r, RAIN), row[1], 1e-12 * row[1] + 1e-15)
		if is_finite(row[2]) and row[0] < 1.0:
			# Near the horizon r as given rounds away digits of 1 - u.
			var tolerance := 1e-12 * row[2] + 1e-15 / (1.0 - row[0])
			assert_almost_eq(0.5 * LensingTable.shadow_angle(r, STATIC), row[2], tolerance)


func test_no_static_shadow_inside(r: float = use_parameters([1.0, 0.5, 0.0, -1.0, NAN])) -> void:
	assert_true(is_nan(LensingTable.shadow_angle(r, STATIC)))
	if r > 0.0:
		assert_gt(LensingTable.shadow_angle(r, RAIN), 0.0)
	else:
		assert_true(is_nan(LensingTable.shadow_angle(r, RAIN)))


func test_einstein_rings_at_10() -> void:
	# Two images of a star close to the axis lie as far inside as outside of the ring.
	var close := 1e-3
	var behind := Vector3(sin(close), 0, -cos(close))
	var before := Vector3(sin(close), 0, cos(close))
	assert_almost_eq(_ring(behind, 0, 1), 29.8283179057, 2e-5)
	assert_almost_eq(_ring(before, 1, 2), 14.6089932189, 2e-5)
	assert_almost_eq(_ring(behind, 2, 3), 14.2830912603, 2e-5)


func test_images_of_the_reference() -> void:
	var rows := _rows("images.csv")
	var compared := 0
	for row in rows:
		# Vector3 has single precision: neither far eyes nor stars near the axis keep enough digits.
		if row[0] < 1e-3 or absf(sin(row[1])) < 0.05 or absf(row[0] - 1.0) < 0.01:
			continue
		compared += 1
		var order := int(row[2])
		var star := Vector3(sin(row[1]), 0, cos(row[1]))
		var place := Vector3(0, 0, 1.0 / row[0])
		_compare_image(LensingTable.star_image(place, star, order, RAIN), row, 5)
		if is_finite(row[8]):
			_compare_image(LensingTable.star_image(place, star, order, STATIC), row, 8)
	assert_gt(compared, 100)


func test_trace_undoes_star_image(motion: int = use_parameters([STATIC, RAIN])) -> void:
	var place := Vector3(1.5, -2.0, 0.7)
	var star := Vector3(-0.3, 0.9, 0.4).normalized()
	for order in 3:
		var image: Dictionary = LensingTable.star_image(place, star, order, motion)
		var ray: Dictionary = LensingTable.trace(place, image["direction"], motion)
		assert_false(ray["captured"])
		# Rounding of the direction grows by 23 with every half turn.
		var tolerance := 1e-5 * pow(30.0, order)
		assert_lt(ray["sky_direction"].angle_to(star), tolerance, "order %d" % order)
		assert_almost_eq(ray["redshift"], image["redshift"], 1e-4)


func test_the_hole_captures_what_points_at_it() -> void:
	var place := Vector3(0, 0, 4)
	assert_true(LensingTable.trace(place, Vector3(0, 0, -1), STATIC)["captured"])
	var ray: Dictionary = LensingTable.trace(place, Vector3(0, 0, 1), STATIC)
	assert_false(ray["captured"])
	assert_true(ray["sky_direction"].is_equal_approx(Vector3(0, 0, 1)))
	# Straight outwards: g = 1 / sqrt(1 - u).
	assert_almost_eq(ray["redshift"], 1.0 / sqrt(0.75), 1e-12)


func test_falling_through_the_horizon_is_smooth() -> void:
	var star := Vector3(1, 0.2, 0.1)
	var above: Dictionary = LensingTable.star_image(Vector3(0, 0, 1.0001), star, 0, RAIN)
	var below: Dictionary = LensingTable.star_image(Vector3(0, 0, 0.9999), star, 0, RAIN)
	assert_almost_eq(above["xi"], below["xi"], 1e-3)
	assert_almost_eq(above["magnification"], below["magnification"], 1e-2)


func test_impossible_questions_are_errors_with_a_reason() -> void:
	var star := Vector3.RIGHT
	assert_eq(LensingTable.star_image(Vector3(0, 0, 0.5), star, 0, STATIC), {})
	assert_push_error("LensingTable.star_image")
	assert_eq(LensingTable.star_image(Vector3.ZERO, star, 0, RAIN), {})
	assert_push_error("LensingTable.star_image")
	assert_eq(LensingTable.star_image(Vector3(0, 0, 5), Vector3.ZERO, 0, RAIN), {})
	assert_push_error("direction")
	assert_eq(LensingTable.star_image(Vector3(0, 0, 5), star, -1, RAIN), {})
	assert_push_error("order")
	assert_eq(LensingTable.trace(Vector3(0, 0, 0.5), star, STATIC), {})
	assert_push_error("LensingTable.trace")
	assert_eq(LensingTable.trace(Vector3(0, 0, 5), Vector3(NAN, 0, 0), RAIN), {})
	assert_push_error("direction")


func _ring(star: Vector3, lower: int, upper: int) -> float:
	var place := Vector3(0, 0, 10)
	var inner: Dictionary = LensingTable.star_image(place, star, lower, STATIC)
	var outer: Dictionary = LensingTable.star_image(place, star, upper, STATIC)
	return rad_to_deg(0.5 * (inner["xi"] + outer["xi"]))


## An image against the three columns xi, mu, g from `first` on.
func _compare_image(image: Dictionary, row: PackedFloat64Array, first: int) -> void:
	var what := "u = %s, phi = %s, order %s" % [row[0], row[1], row[2]]
	assert_almost_eq(image["orbital_angle"], row[3], 3e-6, what)
	assert_almost_eq(image["xi"], row[first], 3e-6, what)
	var mu := row[first + 1]
	assert_almost_eq(image["magnification"], mu, 1e-4 * mu, what)
	var g := row[first + 2]
	assert_almost_eq(image["redshift"], g, 1e-5 * g, what)
	var direction: Vector3 = image["direction"]
	assert_almost_eq(signf(direction.x), row[4], 0.0, "side of " + what)


func _rows(file_name: String) -> Array[PackedFloat64Array]:
	var rows: Array[PackedFloat64Array] = []
	for line in FileAccess.get_file_as_string(REFERENCE + file_name).split("\n", false):
		var row := PackedFloat64Array()
		for field in line.split(","):
			row.append(field.to_float() if field.is_valid_float() else NAN)
		if is_finite(row[0]):
			rows.append(row)
	return rows
