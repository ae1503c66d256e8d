# SPDX-License-Identifier: MIT
extends GutTest
## The stars' names that come with the addon, and what of other tables is refused.

const HEADER: String = "hip,name,ra_deg,dec_deg,vmag\n"

var _folder := ScratchFolder.new("star_names")


func test_the_shipped_names() -> void:
	var shipped := StarNames.load_file()
	assert_eq(shipped.error, "")
	assert_eq(shipped.names.size(), 378)
	assert_eq(shipped.hips.size(), 378)
	assert_eq(shipped.directions.size(), 378)
	assert_eq(shipped.magnitudes.size(), 378)
	assert_eq(shipped.names.slice(0, 3), PackedStringArray(["Sirius", "Canopus", "Arcturus"]))
	assert_gt(shipped.names.find("Polaris"), 0)
	var polaris := shipped.directions[shipped.names.find("Polaris")]
	assert_lt(polaris.angle_to(Vector3.UP), deg_to_rad(0.8))


func test_places_and_names_are_the_catalogue_s() -> void:
	var stars := StarCatalogue.new()
	assert_eq(stars.load_file("res://addons/blackhole_sky/data/hipparcos.stars"), OK)
	var shipped := StarNames.load_file()
	for i in shipped.hips.size():
		var index := stars.find_hip(shipped.hips[i])
		assert_eq(shipped.names[i], stars.get_star_name(index))
		assert_lt(shipped.directions[i].distance_to(stars.get_star_direction(index)), 1e-6)
		assert_almost_eq(shipped.magnitudes[i], stars.get_star_magnitude(index), 0.006)


func test_a_small_table() -> void:
	var read := _read(HEADER + '7,"One, two",90,0,-1.5\n8,\u00c9toile,0,90,2\n9,C,1,2,2\n')
	assert_eq(read.error, "")
	assert_eq(read.names, PackedStringArray(["One, two", "\u00c9toile", "C"]))
	assert_eq(read.hips, PackedInt32Array([7, 8, 9]))
	assert_true(read.directions[0].is_equal_approx(Vector3(0, 0, -1)), "RA 6h")
	assert_true(read.directions[1].is_equal_approx(Vector3.UP), "north pole")
	assert_eq(read.count_to(-2.0), 0)
	assert_eq(read.count_to(-1.5), 1)
	assert_eq(read.count_to(2.0), 3)
	assert_eq(read.count_to(5.0), 3)


func test_a_missing_file() -> void:
	var read := StarNames.load_file("res://no/such.csv")
	assert_string_contains(read.error, "res://no/such.csv")
	assert_string_contains(read.error, "Check the path")
	assert_eq(read.names.size(), 0)


func test_bad_tables_are_refused_by_name(
	p: Array = use_parameters(
		[
			["", "empty"],
			["hip,name,ra_deg,dec_deg\n1,A,0,0\n", "first line"],
			[HEADER, "no star"],
			[HEADER + "1,A,0,0\n", "line 2"],
			[HEADER + "1,A,0,0,1,2\n", "line 2"],
			[HEADER + "1,A,0,0,1\n\n", "line 3"],
			[HEADER + "A,A,0,0,1\n", "line 2"],
			[HEADER + "0,A,0,0,1\n", "Hipparcos"],
			[HEADER + "1,,0,0,1\n", "a name"],
			[HEADER + "1,A,nan,0,1\n", "nan"],
			[HEADER + "1,A,0,inf,1\n", "inf"],
			[HEADER + "1,A,0,0,\n", "no number"],
			[HEADER + "1,A,0,0,1e300\n", "no magnitude"],
			[HEADER + "1,A,360.5,0,1\n", "360.5"],
			[HEADER + "1,A,0,-91,1\n", "-91"],
			[HEADER + "1,A,0,0,1\n2,B,0,0,0.5\n", "line 3 is brighter"],
		]
	)
) -> void:
	var read := _read(p[0])
	assert_string_contains(read.error, "bad.csv")
	assert_string_contains(read.error, p[1])
	assert_eq(read.names.size(), 0, "nothing of it is taken")
	assert_eq(read.magnitudes.size(), 0)


func _read(text: String) -> StarNames:
	return StarNames.load_file(_folder.write_text("bad.csv", text))
