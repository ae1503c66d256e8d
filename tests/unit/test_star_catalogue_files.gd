# SPDX-License-Identifier: MIT
extends GutTest
## Star catalogues from CSV, from arrays and from damaged files.

const BUILT_IN: String = "res://addons/blackhole_sky/data/hipparcos.stars"
const HEADER: String = "ra_deg,dec_deg,vmag\n"

var _folder := ScratchFolder.new("catalogues")
var _stars: StarCatalogue


func before_each() -> void:
	_stars = StarCatalogue.new()


func test_csv_with_all_columns() -> void:
	var text := (
		"# a comment\nname,HIP,ra_deg,dec_deg,vmag,bv,temperature_k,parallax_mas,remark\n"
		+ "faint,7,90,0,5.5,0.5,,12.5,any\n"
		+ '"a ""bright"" one, \u03b1",8,0,90,-1.5,,4000,,\n'
	)
	watch_signals(_stars)
	assert_eq(_stars.load_file(_folder.write_text("all.csv", text)), OK)
	assert_signal_emit_count(_stars, "changed", 1)
	assert_eq(_stars.get_star_count(), 2)
	assert_eq(_stars.get_star_name(0), 'a "bright" one, \u03b1')
	assert_eq(_stars.get_star_hip(0), 8)
	assert_almost_eq(_stars.get_star_magnitude(0), -1.5, 1e-6)
	assert_almost_eq(_stars.get_star_temperature(0), 4000.0, 1e-3)
	assert_true(is_nan(_stars.get_star_color_index(0)), "no B-V given")
	assert_true(is_nan(_stars.get_star_parallax(0)), "no parallax given")
	assert_true(_stars.get_star_direction(0).is_equal_approx(Vector3.UP), "the north pole")
	assert_true(_stars.get_star_direction(1).is_equal_approx(Vector3(0, 0, -1)), "RA 6h")
	assert_between(_stars.get_star_temperature(1), 5500.0, 7500.0, "from B-V 0.5")
	assert_eq(_stars.find_hip(7), 1)


func test_bytes_of_either_kind() -> void:
	watch_signals(_stars)
	assert_eq(_stars.load_bytes(FileAccess.get_file_as_bytes(BUILT_IN)), OK)
	assert_eq(_stars.get_star_count(), 118217)
	_stars.source_file = _folder.write_text("two.csv", HEADER + "1,2,3\n4,5,6\n")
	assert_eq(_stars.load_bytes((HEADER + "-15,20,3\n").to_utf8_buffer()), OK)
	assert_eq(_stars.get_star_count(), 1)
	assert_eq(_stars.source_file, "")
	assert_signal_emit_count(_stars, "changed", 3)
	assert_ne(_stars.load_bytes("ra_deg\n1\n".to_utf8_buffer(), "my download"), OK)
	assert_push_error("my download")
	assert_eq(_stars.get_star_count(), 1, "which stays")


func test_csv_with_the_least_columns() -> void:
	assert_eq(_stars.load_file(_folder.write_text("least.csv", HEADER + "-15,20,3\n")), OK)
	assert_almost_eq(_stars.get_star_temperature(0), 5772.0, 1.0, "the Sun's without a colour")
	assert_eq(_stars.get_star_hip(0), 0)
	assert_eq(_stars.get_star_name(0), "")


func test_bad_csv_is_refused_by_name(
	p: Array = use_parameters(
		[
			["", "empty"],
			["ra_deg,vmag\n1,2\n", "dec_deg"],
			["ra_deg,dec_deg,vmag,vmag\n1,2,3,4\n", "vmag"],
			[HEADER, "no star"],
			[HEADER + "1,2,nan\n", "nan"],
			[HEADER + "1,2,inf\n", "inf"],
			[HEADER + "1,2,\n", "line 2"],
			[HEADER + "1,2,bright\n", "bright"],
			[HEADER + "1,2,3\n1,91,3\n", "line 3"],
			[HEADER + "361,2,3\n", "361"],
			[HEADER + '"1,2,3\n', "quote"],
			["ra_deg,dec_deg,vmag,temperature_k\n1,2,3,-5\n", "temperature_k"],
			["ra_deg,dec_deg,vmag,hip\n1,2,3,1.5\n", "hip"],
		]
	)
) -> void:
	var path := _folder.write_text("bad.csv", p[0])
	_expect_refusal(path, [path, p[1]])


func test_damaged_star_files_are_refused() -> void:
	var good := FileAccess.get_file_as_bytes(BUILT_IN)
	_expect_refusal(_folder.write_bytes("empty.stars", []), ["empty.stars", "not a .stars"])
	_expect_refusal(_folder.write_bytes("head.stars", good.slice(0, 20)), ["head.stars"])
	_expect_refusal(
		_folder.write_bytes("cut.stars", good.slice(0, 1000000)), ["cut.stars", "truncated"]
	)
	var other := good.duplicate()
	other[0] = 65
	_expect_refusal(_folder.write_bytes("magic.stars", other), ["magic.stars", "not a .stars"])
	other = good.duplicate()
	other[8] = 77
	_expect_refusal(_folder.write_bytes("version.stars", other), ["version 77", "rebuild"])
	other = good.duplicate()
	other[100000] ^= 1
	_expect_refusal(_folder.write_bytes("flipped.stars", other), ["checksum"])


func test_a_missing_file() -> void:
	assert_eq(_stars.load_file("res://no/such.csv"), ERR_FILE_CANT_OPEN)
	assert_push_error("res://no/such.csv")
	assert_string_contains(_stars.get_error_message(), "Check the path")
	assert_eq(_stars.get_star_count(), 0)


func test_a_refused_file_leaves_the_stars_as_they_were() -> void:
	_stars.load_file(_folder.write_text("good.csv", HEADER + "1,2,3\n"))
	watch_signals(_stars)
	_expect_refusal(_folder.write_text("bad.csv", HEADER), ["no star"])
	assert_eq(_stars.get_star_count(), 1)
	assert_signal_not_emitted(_stars, "changed")
	assert_eq(_stars.load_file(_folder.write_text("good.csv", HEADER + "1,2,3\n4,5,6\n")), OK)
	assert_eq(_stars.get_error_message(), "", "a good file clears the message")


func test_source_file_loads_and_is_stored() -> void:
	_stars.source_file = _folder.write_text("stored.csv", HEADER + "1,2,3\n4,5,6\n")
	assert_eq(_stars.get_star_count(), 2)
	var path := _folder.file("stored.tres")
	assert_eq(ResourceSaver.save(_stars, path), OK)
	var loaded: StarCatalogue = ResourceLoader.load(path, "", ResourceLoader.CACHE_MODE_IGNORE)
	assert_eq(loaded.get_star_count(), 2)


func test_stars_from_arrays() -> void:
	watch_signals(_stars)
	var directions: PackedVector3Array = [Vector3(0, 0, -5), Vector3(0, 2, 0)]
	assert_eq(_stars.set_stars(directions, [4.0, 2.0], [3000.0, 9000.0]), OK)
	assert_signal_emit_count(_stars, "changed", 1)
	assert_almost_eq(_stars.get_star_magnitude(0), 2.0, 1e-6, "sorted")
	assert_true(_stars.get_star_direction(0).is_equal_approx(Vector3.UP), "normalised")
	assert_almost_eq(_stars.get_star_temperature(1), 3000.0, 1e-3)
	assert_eq(_stars.set_stars(directions, [4.0, 2.0]), OK, "temperatures may be left out")
	assert_almost_eq(_stars.get_star_temperature(1), 5772.0, 1.0)
	assert_eq(_stars.set_stars([], []), OK, "none at all")
	assert_eq(_stars.get_star_count(), 0)


func test_bad_arrays_are_refused(
	p: Array = use_parameters(
		[
			[[Vector3.UP], [], [], "length"],
			[[Vector3.UP], [1.0], [5000.0, 5000.0], "length"],
			[[Vector3.UP, Vector3.ZERO], [1.0, 2.0], [], "star 1"],
			[[Vector3(INF, 0, 0)], [1.0], [], "star 0"],
			[[Vector3.UP], [NAN], [], "star 0"],
			[[Vector3.UP], [1.0], [0.0], "star 0"],
			[[Vector3.UP], [1.0], [INF], "star 0"],
		]
	)
) -> void:
	_stars.set_stars([Vector3.UP, Vector3.DOWN, Vector3.LEFT], [1.0, 2.0, 3.0])
	var directions := PackedVector3Array(p[0])
	var magnitudes := PackedFloat32Array(p[1])
	var kelvins := PackedFloat32Array(p[2])
	assert_ne(_stars.set_stars(directions, magnitudes, kelvins), OK)
	assert_push_error(p[3])
	assert_string_contains(_stars.get_error_message(), p[3])
	assert_eq(_stars.get_star_count(), 3, "nothing was taken over")


func _expect_refusal(path: String, words: PackedStringArray) -> void:
	assert_eq(_stars.load_file(path), ERR_FILE_CORRUPT)
	assert_push_error(words[0])
	for word in words:
		assert_string_contains(_stars.get_error_message(), word)
