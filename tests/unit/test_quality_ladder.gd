# SPDX-License-Identifier: MIT
extends GutTest
## The ladder goes down while pictures come late, up when there is time, and does not swing between.

const RATE: float = 72.0
const PERIOD: float = 1.0 / RATE
## What each rung takes of a picture's time, from the top, at a burden of 1.
const COSTS: PackedFloat32Array = [1.0, 0.7, 0.5, 0.35, 0.2]

var _sky: BlackHoleSky
var _disk: AccretionDisk
var _viewport: SubViewport
var _ladder: QualityLadder


func before_each() -> void:
	_sky = BlackHoleSky.new()
	_sky.image_orders = 4
	_sky.magnitude_limit = 12.0
	_sky.psf_model = BlackHoleSky.PSF_EYE
	_disk = AccretionDisk.new()
	_disk.orders = 4
	_sky.add_child(_disk)
	_viewport = SubViewport.new()
	_ladder = QualityLadder.new()
	_ladder.sky = _sky
	_ladder.disk = _disk
	_ladder.viewport = _viewport
	_ladder.fallback_rate = RATE
	for node: Node in [_sky, _viewport, _ladder]:
		add_child_autofree(node)
	_ladder.set_process(false)


func test_stays_up_while_pictures_come_in_time() -> void:
	watch_signals(_ladder)
	_run(120.0, 0.9)
	assert_eq(_ladder.get_rung(), 0)
	assert_signal_not_emitted(_ladder, "quality_changed")


func test_goes_down_at_once_and_one_step_a_second_at_most() -> void:
	watch_signals(_ladder)
	_see(0.2, PERIOD)
	_see(1.05, 2.0 * PERIOD)
	assert_eq(_ladder.get_rung(), 1, "after a second")
	_see(0.9, 2.0 * PERIOD)
	assert_eq(_ladder.get_rung(), 1, "not twice within a second")
	_see(10.0, 2.0 * PERIOD)
	assert_eq(_ladder.get_rung(), _ladder.get_lowest_rung(), "down to the last")
	assert_signal_emit_count(_ladder, "quality_changed", _ladder.get_lowest_rung())
	assert_signal_emitted_with_parameters(_ladder, "quality_changed", [1], 0)


func test_a_few_late_pictures_are_forgiven() -> void:
	for i in 72 * 60:
		_ladder.see_frame(2.0 * PERIOD if i % 16 == 0 else PERIOD)
	assert_eq(_ladder.get_rung(), 0, "6 % late")
	for i in 72:
		_ladder.see_frame(2.0 * PERIOD if i % 7 == 0 else PERIOD)
	assert_eq(_ladder.get_rung(), 1, "14 % late")


func test_a_long_pause_is_no_late_picture() -> void:
	for i in 20:
		_see(0.5, PERIOD)
		_ladder.see_frame(3.0)
	assert_eq(_ladder.get_rung(), 0)


func test_goes_up_when_there_is_time_to_spare() -> void:
	_run(4.0, 2.5)
	assert_eq(_ladder.get_rung(), 3, "the first rung that is cheap enough")
	_run(8.5, 0.5)
	assert_eq(_ladder.get_rung(), 3, "not yet")
	_run(2.0, 0.5)
	assert_eq(_ladder.get_rung(), 2, "after ten seconds one step")
	_run(25.0, 0.5)
	assert_eq(_ladder.get_rung(), 0, "and so on to the top")


func test_some_late_pictures_keep_it_from_going_up() -> void:
	_run(6.0, 1.3)
	var rung := _ladder.get_rung()
	assert_gt(rung, 0)
	for i in 72 * 60:
		_ladder.see_frame(2.0 * PERIOD if i % 30 == 0 else PERIOD)
	assert_eq(_ladder.get_rung(), rung, "3 % late")


func test_a_step_up_that_fails_is_tried_ever_more_rarely() -> void:
	# At this burden the top is too dear and the first rung is not.
	_run(3.0, 1.3)
	watch_signals(_ladder)
	_run(600.0, 1.3)
	var tries: int = get_signal_emit_count(_ladder, "quality_changed")
	assert_between(tries, 8, 14, "ten minutes: waits of 10, 20, 40, 80, 160 and 300 s")
	assert_true(_ladder.get_rung() in [0, 1])
	_run(3.0, 1.3)
	assert_eq(_ladder.get_rung(), 1)
	# When the load is gone for good the long wait is forgotten.
	_run(320.0, 0.5)
	assert_eq(_ladder.get_rung(), 0)
	_run(3.0, 1.3)
	assert_eq(_ladder.get_rung(), 1)
	_run(12.0, 0.5)
	assert_eq(_ladder.get_rung(), 0)


func test_a_real_load_brings_it_down() -> void:
	_ladder.fallback_rate = 20.0
	_ladder.set_process(true)
	var until := Time.get_ticks_msec() + 6000
	while Time.get_ticks_msec() < until and _ladder.get_rung() < 2:
		OS.delay_msec(80)
		await get_tree().process_frame
	assert_eq(_ladder.get_rung(), 2)
	until = Time.get_ticks_msec() + 2500
	while Time.get_ticks_msec() < until:
		OS.delay_msec(5)
		await get_tree().process_frame
	assert_eq(_ladder.get_rung(), 2, "without the load it stays")


func test_rungs_set_what_they_say() -> void:
	for rung in range(1, _ladder.get_lowest_rung() + 1):
		_ladder.step_to(rung)
		var wanted := _ladder.rungs[rung - 1]
		assert_eq(_sky.image_orders, wanted.image_orders)
		assert_almost_eq(_sky.magnitude_limit, wanted.magnitude_limit, 1e-5)
		assert_eq(_disk.orders, wanted.disk_orders)
		assert_almost_eq(_viewport.scaling_3d_scale, wanted.render_scale, 1e-5)
		var plain := _sky.psf_model == BlackHoleSky.PSF_GAUSSIAN
		assert_eq(plain, wanted.plain_stars)
	_ladder.step_to(0)
	_assert_as_chosen()


func test_rungs_go_from_dear_to_cheap(
	rungs: Array = use_parameters([QualityLadder.standard_rungs(), StandaloneQuality.rungs()])
) -> void:
	for i in range(1, rungs.size()):
		var dear: QualityRung = rungs[i - 1]
		var cheap: QualityRung = rungs[i]
		assert_lte(cheap.image_orders, dear.image_orders)
		assert_lte(cheap.magnitude_limit, dear.magnitude_limit)
		assert_lte(cheap.disk_orders, dear.disk_orders)
		assert_lte(cheap.render_scale, dear.render_scale)
		assert_true(cheap.plain_stars or not dear.plain_stars)


func test_less_than_a_rung_allows_stays() -> void:
	_ladder.enabled = false
	_sky.image_orders = 1
	_sky.magnitude_limit = 5.0
	_ladder.enabled = true
	_ladder.step_to(1)
	assert_eq(_sky.image_orders, 1)
	assert_almost_eq(_sky.magnitude_limit, 5.0, 1e-5)


func test_what_is_chosen_meanwhile_is_the_top() -> void:
	_ladder.step_to(2)
	_sky.image_orders = 3
	_ladder.step_to(3)
	assert_eq(_sky.image_orders, _ladder.rungs[2].image_orders)
	_ladder.step_to(0)
	assert_eq(_sky.image_orders, 3)
	assert_almost_eq(_sky.magnitude_limit, 12.0, 1e-5, "the rest as it was")


func test_switched_off_it_gives_everything_back() -> void:
	_run(6.0, 2.5)
	assert_gt(_ladder.get_rung(), 0)
	_ladder.enabled = false
	assert_eq(_ladder.get_rung(), 0)
	_assert_as_chosen()
	_run(6.0, 2.5)
	assert_eq(_ladder.get_rung(), 0)


func test_without_a_rate_it_does_nothing() -> void:
	_ladder.fallback_rate = 0.0
	_run(6.0, 4.0)
	assert_eq(_ladder.get_rung(), 0)


func test_standalone_headsets_begin_with_less() -> void:
	var session: XrSession = autofree(XrSession.new())
	session.foveated = false
	StandaloneQuality.apply(_ladder, session)
	assert_eq(_sky.image_orders, 2)
	assert_almost_eq(_sky.magnitude_limit, 6.5, 1e-5)
	assert_eq(_sky.psf_model, BlackHoleSky.PSF_GAUSSIAN)
	assert_true(session.foveated)
	assert_eq(_ladder.rungs.size(), StandaloneQuality.rungs().size())


func _assert_as_chosen() -> void:
	assert_eq(_sky.image_orders, 4)
	assert_almost_eq(_sky.magnitude_limit, 12.0, 1e-5)
	assert_eq(_sky.psf_model, BlackHoleSky.PSF_EYE)
	assert_eq(_disk.orders, 4)
	assert_almost_eq(_viewport.scaling_3d_scale, 1.0, 1e-5)


## Frames of this length for so many seconds.
func _see(seconds: float, frame: float) -> void:
	for i in roundi(seconds / frame):
		_ladder.see_frame(frame)


## So many seconds on a machine that needs `burden` pictures' time for the top rung: a headset waits
## for whole pictures.
func _run(seconds: float, burden: float) -> void:
	var passed := 0.0
	while passed < seconds:
		var frame := PERIOD * maxf(ceilf(burden * COSTS[_ladder.get_rung()]), 1.0)
		_ladder.see_frame(frame)
		passed += frame
