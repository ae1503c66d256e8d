# SPDX-License-Identifier: MIT
extends GutTest
## The guide leads through a tour in order and in time, by itself and by hand.


class FakeStage:
	extends TourStage
	var calls := PackedStringArray()
	var travel_left: float = 0.0
	var ready_for: bool = true

	func begin() -> void:
		calls.append("begin")

	func arrive(station: TourStation) -> void:
		travel_left = station.travel_seconds
		calls.append("arrive %s" % station.id)

	func is_arrived() -> bool:
		return travel_left <= 0.0

	func show_caption(index: int, by_hand: bool) -> void:
		calls.append("caption %d%s" % [index, " by hand" if by_hand else ""])

	func is_ready_for(_caption: TourCaption) -> bool:
		return ready_for

	func set_paused(paused: bool) -> void:
		calls.append("paused" if paused else "on")

	func advance(seconds: float) -> void:
		travel_left -= seconds

	func leave() -> void:
		calls.append("leave")


var _stage: FakeStage
var _guide: TourGuide


func before_each() -> void:
	_stage = FakeStage.new()
	_guide = TourGuide.new()
	_guide.stage = _stage
	add_child_autofree(_stage)
	add_child_autofree(_guide)
	_guide.set_process(false)
	watch_signals(_guide)


func _tour(stations: int = 2, captions: int = 2) -> Tour:
	var tour := Tour.new()
	for i in stations:
		var station := TourStation.new()
		station.id = "s%d" % i
		station.title = "Station %d" % i
		station.travel_seconds = 1.0
		for j in captions:
			var caption := TourCaption.new()
			caption.text = "%d %d" % [i, j]
			caption.seconds = 2.0
			station.captions.append(caption)
		tour.stations.append(station)
	return tour


func _elapse(seconds: float) -> void:
	for i in roundi(seconds * 10.0):
		_guide.advance(0.1)


func _at() -> Array[int]:
	return [_guide.station_index, _guide.caption_index]


func test_it_goes_through_everything_by_itself() -> void:
	assert_true(_guide.start(_tour()))
	assert_true(_guide.is_on())
	assert_eq(_at(), [0, 0])
	_elapse(2.9)
	assert_eq(_at(), [0, 0], "the way does not count")
	_elapse(0.3)
	assert_eq(_at(), [0, 1])
	_elapse(2.1)
	assert_eq(_at(), [1, 0])
	_elapse(5.4)
	assert_false(_guide.is_on())
	assert_signal_emitted_with_parameters(_guide, "finished", [true])
	assert_signal_emit_count(_guide, "station_begun", 2)
	# Four captions, and none at the end.
	assert_signal_emit_count(_guide, "caption_changed", 5)
	assert_eq(_stage.calls[-1], "leave")


func test_patience_stretches_the_time() -> void:
	_guide.patience = 2.0
	_guide.start(_tour())
	_elapse(4.8)
	assert_eq(_at(), [0, 0])
	_elapse(0.4)
	assert_eq(_at(), [0, 1])


func test_the_stage_has_the_last_word() -> void:
	var headset := XrTourStage.new()
	add_child_autofree(headset)
	var caption := TourCaption.new()
	caption.text = "On a screen."
	assert_eq(headset.words_of(caption), "On a screen.")
	caption.headset_text = "In a headset."
	assert_eq(headset.words_of(caption), "In a headset.")
	assert_eq(_stage.words_of(caption), "On a screen.")


func test_by_hand_alone() -> void:
	_guide.automatic = false
	_guide.start(_tour())
	_elapse(20.0)
	assert_eq(_at(), [0, 0])
	assert_eq(_guide.get_progress(), 1.0)
	_guide.next()
	assert_eq(_at(), [0, 1])
	assert_eq(_stage.calls[-1], "caption 1 by hand")
	_guide.next()
	assert_eq(_at(), [1, 0])
	_guide.previous()
	assert_eq(_at(), [0, 0])
	_guide.next()
	_guide.previous()
	assert_eq(_at(), [0, 0])
	_guide.previous()
	assert_eq(_at(), [0, 0], "there is none before the first")
	_guide.next_station()
	assert_eq(_at(), [1, 0])
	_guide.next_station()
	assert_false(_guide.is_on(), "after the last one it is over")


func test_a_pause_stops_the_clock_and_the_stage() -> void:
	_guide.start(_tour())
	_elapse(1.5)
	_guide.toggle_pause()
	assert_eq(_stage.calls[-1], "paused")
	_elapse(30.0)
	assert_eq(_at(), [0, 0])
	_guide.toggle_pause()
	assert_eq(_stage.calls[-1], "on")
	_elapse(1.7)
	assert_eq(_at(), [0, 1])
	assert_signal_emit_count(_guide, "pause_changed", 2)


func test_going_on_by_hand_ends_a_pause() -> void:
	_guide.start(_tour())
	_guide.set_paused(true)
	_guide.next()
	assert_false(_guide.is_paused())


func test_it_waits_for_a_ride() -> void:
	_guide.start(_tour())
	_stage.ready_for = false
	_elapse(20.0)
	assert_eq(_at(), [0, 0])
	_stage.ready_for = true
	_elapse(0.1)
	assert_eq(_at(), [0, 1])


func test_it_can_be_left_and_started_anew() -> void:
	_guide.start(_tour())
	_guide.leave()
	assert_false(_guide.is_on())
	assert_null(_guide.get_station())
	assert_signal_emitted_with_parameters(_guide, "finished", [false])
	_guide.leave()
	assert_signal_emit_count(_guide, "finished", 1)
	assert_true(_guide.start(_tour(), 1))
	assert_eq(_at(), [1, 0])


func test_a_tour_without_stations_is_refused_and_nothing_happens() -> void:
	assert_false(_guide.start(Tour.new()))
	assert_false(_guide.start(null))
	_guide.tour_file = "res://nowhere.tres"
	assert_false(_guide.begin())
	assert_signal_emit_count(_guide, "failed", 3)
	assert_string_contains(str(get_signal_parameters(_guide, "failed")), "nowhere.tres")
	assert_false(_guide.is_on())
	assert_eq(_stage.calls.size(), 0)
	_guide.next()
	_guide.previous()
	_guide.toggle_pause()
	_elapse(1.0)
	assert_eq(_stage.calls.size(), 0)


func test_the_tour_that_comes_along_begins() -> void:
	assert_true(_guide.begin())
	assert_eq(_stage.calls[1], "arrive far_away")
