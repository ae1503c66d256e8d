# SPDX-License-Identifier: MIT
extends GutTest
## The constellations' figures that come with the addon, and what of other files is refused.

const GOOD: String = (
	'{"id":"Xyz","la":"Nova","de":"Neu","labels":[[90,0]],'
	+ '"lines":[[[0,0],[0,90]],[[180,0],[90,-90]]]}'
)

var _folder := ScratchFolder.new("figures")


func test_the_shipped_figures() -> void:
	var shipped := ConstellationFigures.load_file()
	assert_eq(shipped.error, "")
	assert_eq(shipped.figures.size(), 88)
	for figure in shipped.figures:
		assert_eq(figure.labels.size(), 2 if figure.id == "Ser" else 1, figure.id)
		assert_gt(figure.lines.size(), 0, figure.id)
		for line in figure.lines:
			assert_gt(line.size(), 1, figure.id)
			for direction in line:
				assert_almost_eq(direction.length(), 1.0, 1e-6, figure.id)


func test_lines_run_between_the_catalogue_s_stars() -> void:
	var stars := StarCatalogue.new()
	assert_eq(stars.load_file("res://addons/blackhole_sky/data/hipparcos.stars"), OK)
	var orion := ConstellationFigures.load_file().find("Ori")
	for hip: int in [26727, 26311, 25930, 27989, 24436]:
		var star := stars.get_star_direction(stars.find_hip(hip))
		var nearest := 1.0
		for line in orion.lines:
			for corner in line:
				nearest = minf(nearest, star.distance_to(corner))
		assert_lt(nearest, deg_to_rad(0.1), "HIP %d" % hip)


func test_names() -> void:
	var shipped := ConstellationFigures.load_file()
	var bear := shipped.find("UMa")
	assert_eq(bear.name("la"), "Ursa Major")
	assert_eq(bear.name("de"), "Großer Bär")
	assert_eq(bear.name("de_AT"), "Großer Bär")
	assert_eq(bear.name("fr"), "Ursa Major", "Latin where a language is missing")
	assert_null(shipped.find("Foo"))


func test_axes_of_the_sky() -> void:
	var read := _read('{"constellations":[%s]}' % GOOD)
	assert_eq(read.error, "")
	var figure := read.figures[0]
	assert_true(figure.labels[0].is_equal_approx(Vector3(0, 0, -1)), "RA 6h")
	assert_true(figure.lines[0][0].is_equal_approx(Vector3(1, 0, 0)), "RA 0h")
	assert_true(figure.lines[0][1].is_equal_approx(Vector3(0, 1, 0)), "north pole")
	assert_true(figure.lines[1][0].is_equal_approx(Vector3(-1, 0, 0)), "RA 12h")
	assert_true(figure.lines[1][1].is_equal_approx(Vector3(0, -1, 0)), "south pole")


func test_a_missing_file() -> void:
	var read := ConstellationFigures.load_file("res://no/such.json")
	assert_string_contains(read.error, "res://no/such.json")
	assert_string_contains(read.error, "Check the path")
	assert_eq(read.figures.size(), 0)


func test_bad_files_are_refused_by_name(
	p: Array = use_parameters(
		[
			["", "empty"],
			['{"constellations":[', "no JSON"],
			["[]", "'constellations'"],
			['{"constellations":{}}', "'constellations'"],
			['{"constellations":[]}', "'constellations'"],
			['{"constellations":[7]}', "constellation 1 is not an object"],
			['{"constellations":[%s,%s]}' % [GOOD, GOOD], "'Xyz' comes twice"],
			[_with('"id":"Xyz"', '"id":""'), "'id'"],
			[_with('"la":"Nova"', '"la":3'), "'la'"],
			[_with('"de":"Neu",', ""), "'de'"],
			[_with("[[90,0]]", "[]"), "labels"],
			[_with("[[90,0]]", "90"), "labels"],
			[_with("[[90,0]]", "[[90,0,1]]"), "[90.0,0.0,1.0]"],
			[_with("[[90,0]]", "[[361,0]]"), "361"],
			[_with("[[90,0]]", "[[-0.1,0]]"), "-0.1"],
			[_with("[[90,0]]", "[[1e300,0]]"), "labels"],
			[_with("[0,90]", "[0,90.5]"), "90.5"],
			[_with("[0,90]", '[0,"90"]'), "a line of constellation 1 ('Xyz')"],
			[_with("[0,90]", "[0,null]"), "a line of"],
			[_with("[0,90]", "[0,NaN]"), "no JSON"],
			[_with(",[90,-90]", ""), "at least 2"],
			['{"constellations":[{"id":"A","la":"A","de":"A","labels":[[1,2]]}]}', "'lines'"],
		]
	)
) -> void:
	var read := _read(p[0])
	assert_string_contains(read.error, "bad.json")
	assert_string_contains(read.error, p[1])
	assert_eq(read.figures.size(), 0, "nothing of it is taken")


func test_a_file_cut_short_is_refused() -> void:
	var whole := FileAccess.get_file_as_string(ConstellationFigures.FILE)
	for part: float in [0.1, 0.5, 0.99]:
		var read := _read(whole.left(int(part * whole.length())))
		assert_string_contains(read.error, "no JSON")
		assert_eq(read.figures.size(), 0)


func _with(old: String, new: String) -> String:
	assert(GOOD.contains(old))
	return '{"constellations":[%s]}' % GOOD.replace(old, new)


func _read(text: String) -> ConstellationFigures:
	return ConstellationFigures.load_file(_folder.write_text("bad.json", text))
