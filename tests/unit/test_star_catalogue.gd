# SPDX-License-Identifier: MIT
extends GutTest
## The built-in star catalogue: what is in it, and how stars are asked for.

const BUILT_IN: String = "res://addons/blackhole_sky/data/hipparcos.stars"
const SIRIUS: int = 32349

var _stars: StarCatalogue


func before_all() -> void:
	_stars = StarCatalogue.new()
	_stars.load_file(BUILT_IN)


func test_all_stars_are_there() -> void:
	assert_eq(_stars.get_star_count(), 118217)
	assert_eq(_stars.get_error_message(), "")
	assert_eq(_stars.source_file, BUILT_IN)


func test_the_brightest_comes_first() -> void:
	assert_eq(_stars.get_star_hip(0), SIRIUS)
	for i in range(1, 2000):
		if _stars.get_star_magnitude(i) < _stars.get_star_magnitude(i - 1):
			fail_test("star %d is brighter than the one before" % i)
	assert_gt(_stars.get_star_magnitude(118216), 12.0)


func test_counts_to_a_magnitude(
	p: Array = use_parameters([[-2.0, 0], [6.0, 5044], [6.5, 8874], [8.0, 41411], [10.0, 108003]])
) -> void:
	assert_eq(_stars.count_to_magnitude(p[0]), p[1])


func test_well_known_stars(
	# HIP, V, B-V, parallax in mas
	p: Array = use_parameters(
		[
			[SIRIUS, -1.44, 0.009, 379.21],
			[91262, 0.03, -0.001, 130.23],
			[11767, 1.97, 0.636, 7.54],
			[27989, 0.45, 1.5, 6.55],
			[24436, 0.18, -0.03, 3.78],
			[70890, 11.01, 1.807, 771.64],
		]
	)
) -> void:
	var i := _stars.find_hip(p[0])
	assert_gte(i, 0)
	assert_eq(_stars.get_star_hip(i), p[0])
	assert_almost_eq(_stars.get_star_magnitude(i), p[1], 1e-5)
	assert_almost_eq(_stars.get_star_color_index(i), p[2], 1e-5)
	assert_almost_eq(_stars.get_star_parallax(i), p[3], 1e-3)


func test_directions() -> void:
	var polaris := _stars.get_star_direction(_stars.find_hip(11767))
	assert_lt(rad_to_deg(polaris.angle_to(Vector3.UP)), 0.8, "Polaris stands at the pole")
	# RA 101.2872 degrees, Dec -16.7161 degrees at J2000.
	var right_ascension := deg_to_rad(101.2872)
	var declination := deg_to_rad(-16.7161)
	var flat := cos(declination)
	var expected := Vector3(
		flat * cos(right_ascension), sin(declination), -flat * sin(right_ascension)
	)
	assert_lt(_stars.get_star_direction(0).angle_to(expected), 1e-5, "Sirius")
	assert_almost_eq(_stars.get_star_direction(0).length(), 1.0, 1e-6)


func test_temperatures_keep_the_observed_colour() -> void:
	# The black body of Sirius' B-V, not its effective temperature (9,940 K).
	assert_almost_eq(_stars.get_star_temperature(0), 12800.0, 200.0)
	assert_between(_stars.get_star_temperature(_stars.find_hip(27989)), 2500.0, 4500.0)


func test_unknown_numbers() -> void:
	assert_eq(_stars.find_hip(0), -1)
	assert_eq(_stars.find_hip(-1), -1)
	assert_eq(_stars.find_hip(999999), -1)


func test_places_out_of_range_are_errors(i: int = use_parameters([-1, 118217])) -> void:
	assert_true(is_nan(_stars.get_star_magnitude(i)))
	assert_true(is_nan(_stars.get_star_temperature(i)))
	assert_true(is_nan(_stars.get_star_color_index(i)))
	assert_true(is_nan(_stars.get_star_parallax(i)))
	assert_eq(_stars.get_star_hip(i), 0)
	assert_eq(_stars.get_star_name(i), "")
	assert_eq(_stars.get_star_direction(i), Vector3.ZERO)
	for question in 7:
		assert_engine_error("out of bounds")


func test_some_have_names() -> void:
	assert_eq(_stars.get_star_name(0), "Sirius")
	assert_eq(_stars.get_star_name(118216), "")


func test_loads_quickly() -> void:
	var best := INF
	for attempt in 5:
		var start := Time.get_ticks_usec()
		StarCatalogue.new().load_file(BUILT_IN)
		best = minf(best, (Time.get_ticks_usec() - start) * 1e-3)
	gut.p("%.1f ms" % best)
	# The bench holds the figure to 40 ms; here a busy machine must not fail the tests.
	assert_lt(best, 400.0)
