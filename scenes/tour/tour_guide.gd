# SPDX-License-Identifier: MIT
class_name TourGuide
extends Node
## Leads through a tour: which station and which caption is on, how long it stays, and what comes
## next, by itself or by hand. How a station is shown is the stage's matter.

signal began
## The way to a station begins; the first is 0.
signal station_begun(index: int)
## In English, as in the tour; empty when the tour is over.
signal caption_changed(text: String)
signal pause_changed(paused: bool)
## The tour is over; `completed`: nobody left it.
signal finished(completed: bool)
## There is nothing to be shown, and why.
signal failed(reason: String)

@export_file("*.tres") var tour_file: String = "res://scenes/tour/black_hole_tour.tres"
@export var stage: TourStage
## Goes on by itself when a caption has been read; else only by hand.
@export var automatic: bool = true
## Captions stay so many times as long.
@export_range(0.25, 4.0, 0.05) var patience: float = 1.0

var tour: Tour
var station_index: int = -1
var caption_index: int = -1

var _paused: bool = false
var _clock: float = 0.0


func _process(delta: float) -> void:
	advance(minf(delta, ViewControls.LONGEST_STEP))


## Reads the tour's file and starts it; false, and failed(), when it cannot be shown.
func begin() -> bool:
	var file := TourFile.read(tour_file)
	if not file.error.is_empty():
		return _fail(file.error)
	return start(file.tour)


## Starts a tour at one of its stations; false, and failed(), when it cannot be shown.
func start(which: Tour, at: int = 0) -> bool:
	var problem := "there is none" if which == null else which.find_problem()
	if not problem.is_empty():
		return _fail("The tour cannot be shown: %s." % problem)
	if is_on():
		leave()
	tour = which
	_paused = false
	stage.begin()
	began.emit()
	_go_to(clampi(at, 0, tour.stations.size() - 1), 0)
	return true


func is_on() -> bool:
	return tour != null


func is_paused() -> bool:
	return _paused


func get_station() -> TourStation:
	return tour.stations[station_index] if is_on() else null


func get_caption() -> TourCaption:
	return get_station().captions[caption_index] if is_on() else null


## What is said now, in English; empty when no tour is on.
func get_words() -> String:
	return stage.words_of(get_caption()) if is_on() else ""


## How much of the caption's time is over, 0 to 1.
func get_progress() -> float:
	if not is_on():
		return 0.0
	return clampf(_clock / (get_caption().get_duration() * patience), 0.0, 1.0)


## The next caption, or that of the next station; after the last one the tour is over.
func next() -> void:
	_go_on(true)


## The caption before, or the first one of the station before.
func previous() -> void:
	if not is_on():
		return
	if caption_index > 0:
		_say(caption_index - 1, true)
	else:
		previous_station()


func next_station() -> void:
	if not is_on():
		return
	if station_index + 1 < tour.stations.size():
		_go_to(station_index + 1, 0)
	else:
		_end(true)


## The station before; at the first one, its beginning.
func previous_station() -> void:
	if is_on():
		_go_to(maxi(station_index - 1, 0), 0)


func set_paused(paused: bool) -> void:
	if not is_on() or paused == _paused:
		return
	_paused = paused
	stage.set_paused(paused)
	pause_changed.emit(paused)


func toggle_pause() -> void:
	set_paused(not _paused)


## Ends the tour; all is as it was before it.
func leave() -> void:
	if is_on():
		_end(false)


## Lets `seconds` pass.
func advance(seconds: float) -> void:
	if not is_on() or _paused:
		return
	stage.advance(seconds)
	if not stage.is_arrived():
		return
	_clock += seconds
	if automatic and _clock >= get_caption().get_duration() * patience and _may_go_on():
		_go_on(false)


# On a ride the next caption waits until the ride is there.
func _may_go_on() -> bool:
	var captions := get_station().captions
	if caption_index + 1 >= captions.size():
		return true
	return stage.is_ready_for(captions[caption_index + 1])


func _go_on(by_hand: bool) -> void:
	if not is_on():
		return
	if caption_index + 1 < get_station().captions.size():
		_say(caption_index + 1, by_hand)
	else:
		next_station()


func _go_to(station: int, caption: int) -> void:
	set_paused(false)
	station_index = station
	stage.arrive(get_station())
	station_begun.emit(station)
	_say(caption, false)


func _say(caption: int, by_hand: bool) -> void:
	set_paused(false)
	caption_index = caption
	_clock = 0.0
	stage.show_caption(caption, by_hand)
	caption_changed.emit(get_words())


func _end(completed: bool) -> void:
	set_paused(false)
	tour = null
	station_index = -1
	caption_index = -1
	stage.leave()
	caption_changed.emit("")
	finished.emit(completed)


func _fail(reason: String) -> bool:
	push_warning(reason)
	failed.emit(reason)
	return false
