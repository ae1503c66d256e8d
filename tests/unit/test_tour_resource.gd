# SPDX-License-Identifier: MIT
extends GutTest
## The tour is complete, short enough to be read and there in every language; one that is damaged is
## refused with a message that names the file.

const FILE: String = "res://scenes/tour/black_hole_tour.tres"
const LOCALES: String = "res://scenes/tour/locale/"
const MOST_WORDS: int = 25

var _folder := ScratchFolder.new("tour")


func _texts(tour: Tour) -> PackedStringArray:
	var texts := PackedStringArray([tour.title])
	for station in tour.stations:
		texts.append(station.title)
		for caption in station.captions:
			texts.append(caption.text)
			if not caption.headset_text.is_empty():
				texts.append(caption.headset_text)
	return texts


func test_it_is_complete() -> void:
	var file := TourFile.read(FILE)
	assert_eq(file.error, "")
	assert_between(file.tour.stations.size(), 8, 10)
	var ids: Dictionary[StringName, bool] = {}
	for station in file.tour.stations:
		assert_false(station.id.is_empty() or ids.has(station.id), station.title)
		ids[station.id] = true
		assert_between(station.captions.size(), 2, 4, station.title)
		for caption in station.captions:
			assert_lte(caption.count_words(), MOST_WORDS, caption.text)
			var in_headset := caption.headset_text.split(" ", false).size()
			assert_lte(in_headset, MOST_WORDS, caption.headset_text)


func test_every_text_is_there_in_every_language() -> void:
	var tour := TourFile.read(FILE).tour
	var languages := 0
	for file in DirAccess.get_files_at(LOCALES):
		if not file.ends_with(".po"):
			continue
		languages += 1
		var translation := load(LOCALES + file) as Translation
		for text in _texts(tour):
			assert_ne(translation.get_message(text), &"", "%s: %s" % [file, text])
	assert_gt(languages, 0)


func test_reading_takes_time_by_the_number_of_words() -> void:
	var caption := TourCaption.new()
	caption.text = "Five words are read here"
	var seconds := TourCaption.SECONDS_TO_FIND + 5.0 / TourCaption.WORDS_PER_SECOND
	assert_almost_eq(caption.get_duration(), seconds, 1e-6)
	caption.seconds = 9.0
	assert_eq(caption.get_duration(), 9.0)


func test_what_a_caption_changes_stays_until_the_next_change() -> void:
	var station := TourStation.new()
	station.radius = 10.0
	for i in 3:
		station.captions.append(TourCaption.new())
	station.captions[1].radius = 3.0
	station.captions[1].field_of_view = 20.0
	station.captions[1].look = TourCaption.Look.AWAY
	station.captions[2].image_orders = 4
	assert_eq(station.get_radius_at(0), 10.0)
	assert_eq(station.get_radius_at(2), 3.0)
	assert_eq(station.get_field_at(2), 20.0)
	assert_eq(station.get_look_at(0), TourStation.Look.HOLE)
	assert_eq(station.get_look_at(2), TourStation.Look.AWAY)
	assert_eq(station.get_orders_at(1), 2)
	assert_eq(station.get_orders_at(2), 4)


func test_impossible_places_are_found() -> void:
	var station := TourStation.new()
	station.title = "Here"
	station.captions.append(TourCaption.new())
	station.captions[0].text = "Words."
	assert_eq(station.find_problem(), "")
	station.captions[0].radius = 0.9
	assert_string_contains(station.find_problem(), "hover")
	station.captions[0].radius = 0.0
	station.radius = 1.4
	station.motion = TourStation.Motion.ORBIT
	assert_string_contains(station.find_problem(), "orbit")
	station.radius = 0.9
	station.motion = TourStation.Motion.FALL_FROM_REST
	assert_string_contains(station.find_problem(), "outside")
	station.motion = TourStation.Motion.FALL_FROM_INFINITY
	assert_eq(station.find_problem(), "")


func test_a_missing_file_is_named() -> void:
	var file := TourFile.read("res://scenes/tour/nothing.tres")
	assert_null(file.tour)
	assert_string_contains(file.error, "nothing.tres is missing")


func test_what_is_no_tour_and_what_is_empty_is_refused() -> void:
	var path := _folder.file("tour.tres")
	ResourceSaver.save(Gradient.new(), path)
	assert_string_contains(TourFile.read(path).error, "holds no tour")
	var empty := _folder.file("empty.tres")
	ResourceSaver.save(Tour.new(), empty)
	assert_string_contains(TourFile.read(empty).error, "no stations")


func test_a_damaged_file_is_refused() -> void:
	var path := _folder.write_text("damaged.tres", '[gd_resource type="Reso')
	var file := TourFile.read(path)
	assert_null(file.tour)
	assert_string_contains(file.error, "damaged.tres")
	for error: GutTrackedError in get_errors():
		error.handled = true
