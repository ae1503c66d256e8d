# SPDX-License-Identifier: MIT
extends GutTest
## Observers of a shot: what is read from its words, in double precision, and the limits of what
## can be. The words of the refusals are in tests/data/shots.

const PLACE: PackedFloat64Array = [0.0, 6.0, 8.0]


func test_names_alone() -> void:
	assert_eq(ShotObserver.from_data("static", PLACE).motion, LensingTable.MOTION_STATIC)
	assert_eq(ShotObserver.from_data("rain", PLACE).motion, LensingTable.MOTION_RAIN)
	for word in ShotObserver.MOTIONS:
		var data := {"motion": word, "energy": 1, "beta": [0, 0, 0]}
		assert_eq(ShotObserver.MOTIONS[ShotObserver.from_data(data, PLACE).motion], word)


func test_infall_with_an_energy() -> void:
	var observer := _infall({"energy": 1.25, "outgoing": true})
	assert_eq(observer.error, "")
	assert_eq(observer.energy, 1.25)
	assert_eq(observer.rest_radius, 0.0)
	assert_true(observer.outgoing)
	assert_false(_infall({"energy": 1}).outgoing)


func test_infall_from_rest() -> void:
	var observer := _infall({"rest_radius_rs": 25})
	assert_eq(observer.error, "")
	assert_eq(observer.rest_radius, 25.0)
	assert_almost_eq(observer.energy, sqrt(0.96), 1e-15)
	# The place of rest itself is the last one possible, whatever rounding does there.
	for radius: float in [1.001, 1.7, 3.3, 10.0, 12345.678, 1e12]:
		var place: PackedFloat64Array = [radius, 0.0, 0.0]
		var data := {"motion": "infall", "rest_radius_rs": radius}
		assert_eq(ShotObserver.from_data(data, place).error, "")
	assert_string_contains(_infall({"rest_radius_rs": 9.999}).error, "farther out")


func test_the_least_energy_of_a_place() -> void:
	# 1 - 1/r at r = 10
	assert_eq(_infall({"energy": sqrt(0.9)}).error, "")
	assert_string_contains(_infall({"energy": sqrt(0.9) - 1e-6}).error, "observer: with an energy")


func test_orbit_axes_are_unit_vectors() -> void:
	var observer := ShotObserver.from_data({"motion": "orbit", "axis": [3, 0, -4]}, PLACE)
	assert_eq(observer.error, "")
	assert_lt(Vec3D.length(Vec3D.subtract(observer.axis, [0.6, 0.0, -0.8])), 1e-15)
	observer = ShotObserver.from_data({"motion": "orbit"}, PLACE)
	assert_eq(observer.axis, PackedFloat64Array([0.0, 1.0, 0.0]))
	for axis: Array in [[0, 3, 4], [0, -6, -8]]:
		observer = ShotObserver.from_data({"motion": "orbit", "axis": axis}, PLACE)
		assert_string_contains(observer.error, "observer.axis")


func test_the_innermost_orbit() -> void:
	var data := {"motion": "orbit"}
	assert_eq(ShotObserver.from_data(data, [1.5001, 0.0, 0.0]).error, "")
	for radius: float in [1.5, 1.2, 0.5]:
		var observer := ShotObserver.from_data(data, [radius, 0.0, 0.0])
		assert_string_contains(observer.error, "circular orbit")


func test_beta_becomes_celerity() -> void:
	var observer := _velocity({"beta": [0.36, 0, -0.48], "relative_to": "static"})
	assert_eq(observer.error, "")
	assert_true(observer.relative_to_static)
	# beta 0.6 has the Lorentz factor 1.25
	assert_lt(Vec3D.length(Vec3D.subtract(observer.celerity, [0.45, 0.0, -0.6])), 1e-15)
	# 1 - 2^-40 keeps its digits: gamma^2 = 1 / ((1 - beta)(1 + beta))
	observer = _velocity({"beta": [0, 1.0 - pow(2.0, -40.0), 0]})
	var expected := (1.0 - pow(2.0, -40.0)) * pow(2.0, 20.0) / sqrt(2.0 - pow(2.0, -40.0))
	assert_almost_eq(observer.celerity[1] / expected, 1.0, 1e-12)
	assert_false(observer.relative_to_static)


func test_celerity_is_taken_as_it_is() -> void:
	var observer := _velocity({"celerity": [0, 0, 22.366272042129]})
	assert_eq(observer.error, "")
	assert_eq(observer.celerity, PackedFloat64Array([0.0, 0.0, 22.366272042129]))


func test_light_is_not_reached() -> void:
	for beta: Array in [[1, 0, 0], [0.8, 0.8, 0], [0, 0, -1.5]]:
		assert_string_contains(_velocity({"beta": beta}).error, "observer.beta")


func _infall(data: Dictionary) -> ShotObserver:
	return ShotObserver.from_data(data.merged({"motion": "infall"}), PLACE)


func _velocity(data: Dictionary) -> ShotObserver:
	return ShotObserver.from_data(data.merged({"motion": "velocity"}), PLACE)
