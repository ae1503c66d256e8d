# SPDX-License-Identifier: MIT
extends GutTest
## The way of a visitor through the exhibit, by the director alone: steps, clocks, ways to end; and
## how it is told that a headset is worn.

var _director: VisitDirector
var _states: Array[VisitDirector.State]
var _ends: Array[StringName]


func before_each() -> void:
	_director = VisitDirector.new()
	_states = []
	_ends = []
	_director.state_changed.connect(func(state: VisitDirector.State) -> void: _states.append(state))
	_director.visit_ended.connect(func(how: StringName) -> void: _ends.append(how))


func _go_to_visit() -> void:
	_director.wake(&"button")
	_director.take_language()
	_director.accept_health()
	_director.choose(VisitDirector.FLIGHT)


func _let_pass(seconds: float) -> void:
	for i in roundi(seconds * 4.0):
		_director.advance(0.25)


func test_all_steps() -> void:
	watch_signals(_director)
	_go_to_visit()
	assert_eq(
		_states,
		[
			VisitDirector.State.LANGUAGE,
			VisitDirector.State.HEALTH,
			VisitDirector.State.CHOICE,
			VisitDirector.State.VISIT
		]
	)
	assert_signal_emitted_with_parameters(_director, "visit_begun", [&"button"])
	assert_eq(_director.content, VisitDirector.FLIGHT)
	_director.end(VisitDirector.FINISHED)
	_let_pass(_director.ending_seconds + 0.5)
	assert_eq(_states.slice(4), [VisitDirector.State.ENDING, VisitDirector.State.ATTRACT])
	assert_eq(_ends, [VisitDirector.FINISHED])
	assert_eq(_director.reached, VisitDirector.State.VISIT)


func test_steps_with_nothing_to_ask_are_passed() -> void:
	_director.asks_language = false
	_director.asks_health = false
	_director.contents = [VisitDirector.TOUR]
	_director.wake(&"gaze")
	assert_eq(_states, [VisitDirector.State.VISIT])
	assert_eq(_director.content, VisitDirector.TOUR)


func test_back_and_out() -> void:
	_director.wake(&"button")
	_director.take_language()
	_director.accept_health()
	for expected: VisitDirector.State in [
		VisitDirector.State.HEALTH, VisitDirector.State.LANGUAGE, VisitDirector.State.ATTRACT
	]:
		_director.step_back()
		assert_eq(_director.state, expected)
	assert_eq(_ends, [VisitDirector.DECLINED])


func test_who_goes_away_is_missed_after_a_time_at_every_step() -> void:
	for steps in 4:
		_director.wake(&"button")
		if steps > 0:
			_director.take_language()
		if steps > 1:
			_director.accept_health()
		if steps > 2:
			_director.choose(VisitDirector.TOUR)
		_let_pass(_director.idle_seconds - 1.0)
		_director.touch()
		_let_pass(_director.idle_seconds - 1.0)
		assert_true(_director.is_visiting(), "touched in between")
		_let_pass(1.5)
		assert_eq(_director.state, VisitDirector.State.ATTRACT, "step %d" % steps)
	assert_eq(_ends.count(VisitDirector.IDLE), 4)


func test_the_clock_ends_softly() -> void:
	_director.visit_seconds = 100.0
	_director.notice_seconds = 20.0
	watch_signals(_director)
	_go_to_visit()
	for i in 79:
		_director.touch()
		_let_pass(1.0)
	assert_signal_not_emitted(_director, "end_announced")
	_let_pass(1.0)
	assert_signal_emit_count(_director, "end_announced", 1)
	assert_almost_eq(_director.get_seconds_left(), 20.0, 0.3)
	_director.touch()
	_let_pass(20.0)
	assert_eq(_director.state, VisitDirector.State.ENDING)
	assert_eq(_ends, [VisitDirector.TIME])
	assert_signal_emit_count(_director, "end_announced", 1)


func test_without_a_limit_the_clock_ends_nothing() -> void:
	_director.visit_seconds = 0.0
	_go_to_visit()
	for i in 5000:
		_director.touch()
		_director.advance(1.0)
	assert_eq(_director.state, VisitDirector.State.VISIT)
	assert_eq(_director.get_seconds_left(), INF)


func test_a_headset_that_is_off_ends_the_visit_one_that_is_worn_never_idles() -> void:
	_director.with_headset = true
	_director.visit_seconds = 0.0
	_director.set_worn(true)
	_go_to_visit()
	_let_pass(10.0 * _director.idle_seconds)
	assert_eq(_director.state, VisitDirector.State.VISIT, "watching is no idling")
	_director.set_worn(false)
	_let_pass(_director.off_seconds - 1.0)
	_director.set_worn(true)
	_let_pass(_director.off_seconds)
	assert_eq(_director.state, VisitDirector.State.VISIT, "only pushed up for a moment")
	_director.set_worn(false)
	_let_pass(_director.off_seconds + 0.5)
	assert_eq(_director.state, VisitDirector.State.ATTRACT)
	assert_eq(_ends, [VisitDirector.HEADSET_OFF])


func test_nobody_begins_twice_or_before_all_is_ready() -> void:
	_director.is_ready = false
	assert_false(_director.wake(&"button"))
	_director.is_ready = true
	assert_true(_director.wake(&"button"))
	assert_false(_director.wake(&"button"))
	_director.end(VisitDirector.TIME)
	assert_false(_director.wake(&"button"), "while the last one is thanked")
	_director.end(VisitDirector.OPERATOR)
	assert_eq(_ends, [VisitDirector.TIME], "one visit has one end")


func test_what_comes_too_late_does_nothing() -> void:
	_director.take_language()
	_director.accept_health()
	_director.choose(VisitDirector.TOUR)
	_director.step_back()
	_director.end(VisitDirector.IDLE)
	_let_pass(1000.0)
	assert_eq(_states, [] as Array[VisitDirector.State])


func test_settings() -> void:
	var config := KioskConfig.from_data(
		{"visit_minutes": 3, "content": "tour", "languages": ["de"]}
	)
	_director.configure(config, false)
	assert_eq(_director.visit_seconds, 180.0)
	assert_false(_director.asks_language)
	assert_false(_director.asks_health, "only with the headset")
	assert_eq(_director.contents, [VisitDirector.TOUR])
	_director.configure(KioskConfig.from_data({}), true)
	assert_true(_director.asks_health)


func test_a_headset_is_worn_when_it_moves_as_heads_do() -> void:
	var presence := HeadsetPresence.new()
	var pose := Transform3D.IDENTITY
	for i in 100:
		assert_false(presence.see(true, pose, 0.1), "it lies")
	pose.origin.y = 0.5
	for i in 100:
		assert_false(presence.see(true, pose, 0.1), "pushed once")
	var worn := false
	for i in 30:
		pose.origin.x += 0.01
		worn = presence.see(true, pose, 0.1)
	assert_true(worn)
	for i in 30:
		worn = presence.see(true, pose.rotated_local(Vector3.UP, 0.02 * i), 0.1)
	assert_true(worn, "turning alone is enough")
	assert_false(presence.see(false, pose, 0.1), "the runtime knows better")
	for i in 100:
		worn = presence.see(true, pose, 0.1)
	assert_false(worn, "laid down")


func test_the_daily_restart() -> void:
	var day := 86400.0 * 20000.0
	var four := day + 4.0 * 3600.0
	assert_false(DailyRestart.is_due(4, day + 100.0, four - 1.0))
	assert_true(DailyRestart.is_due(4, day + 100.0, four + 1.0))
	assert_true(
		DailyRestart.is_due(4, day - 80000.0, four + 40000.0), "later, when nobody is there"
	)
	assert_false(DailyRestart.is_due(4, four + 10.0, four + 40000.0), "once a day")
	assert_true(DailyRestart.is_due(4, four + 10.0, four + 86400.0))
	assert_false(DailyRestart.is_due(-1, day, four + 90000.0))
