# SPDX-License-Identifier: MIT
extends GutTest
## What the keys switch, and what is refused.

var _sky: BlackHoleSky
var _switches: SkySwitches


func before_each() -> void:
	_sky = BlackHoleSky.new()
	_switches = SkySwitches.new()
	_switches.sky = _sky
	add_child_autofree(_sky)
	add_child_autofree(_switches)
	watch_signals(_switches)


func test_static_ends_at_the_horizon() -> void:
	assert_true(SkySwitches.can_be_static(1.0001, 1.0))
	assert_false(SkySwitches.can_be_static(1.0, 1.0))
	assert_false(SkySwitches.can_be_static(0.3, 1.0))
	assert_true(SkySwitches.can_be_static(0.3, 0.2), "the horizon of a lighter hole is smaller")
	assert_true(SkySwitches.can_be_static(0.3, 0.0), "without a hole one can stand anywhere")


func test_observer_changes_outside() -> void:
	_switches.next_observer(2.0)
	assert_eq(_sky.observer_motion, LensingTable.MOTION_RAIN)
	_switches.next_observer(2.0)
	assert_eq(_sky.observer_motion, LensingTable.MOTION_STATIC)
	assert_signal_not_emitted(_switches, "warned")


func test_static_is_refused_inside() -> void:
	_sky.observer_motion = LensingTable.MOTION_RAIN
	_switches.next_observer(1.0)
	assert_eq(_sky.observer_motion, LensingTable.MOTION_RAIN)
	assert_signal_emit_count(_switches, "warned", 1)


func test_a_static_observer_at_the_horizon_turns_to_rain_once() -> void:
	_switches.watch_observer(1.5)
	assert_eq(_sky.observer_motion, LensingTable.MOTION_STATIC)
	_switches.watch_observer(1.0)
	_switches.watch_observer(0.9)
	assert_eq(_sky.observer_motion, LensingTable.MOTION_RAIN)
	assert_signal_emit_count(_switches, "warned", 1)


func test_backgrounds_go_round() -> void:
	_sky.panorama = ImageTexture.create_from_image(Image.create(2, 1, false, Image.FORMAT_RGB8))
	_sky.background = BlackHoleSky.BACKGROUND_NONE
	var seen: Array[int] = []
	for i in 3:
		_switches.next_background()
		seen.append(_sky.background)
	assert_eq(
		seen,
		[
			BlackHoleSky.BACKGROUND_GRID,
			BlackHoleSky.BACKGROUND_PANORAMA,
			BlackHoleSky.BACKGROUND_NONE,
		]
	)
	assert_signal_not_emitted(_switches, "warned")


func test_a_missing_panorama_is_left_out() -> void:
	_sky.background = BlackHoleSky.BACKGROUND_GRID
	_switches.next_background()
	assert_eq(_sky.background, BlackHoleSky.BACKGROUND_NONE)
	assert_signal_emit_count(_switches, "warned", 1)


func test_image_orders_go_round() -> void:
	_sky.image_orders = 2
	var seen: Array[int] = []
	for i in 4:
		_switches.next_image_orders()
		seen.append(_sky.image_orders)
	assert_eq(seen, [3, 4, 1, 2])


func test_exposure_has_limits() -> void:
	_sky.exposure = 0.0
	_switches.change_exposure(1)
	assert_almost_eq(_sky.exposure, SkySwitches.EXPOSURE_STEP, 1e-6)
	for i in 100:
		_switches.change_exposure(1)
	assert_almost_eq(_sky.exposure, SkySwitches.EXPOSURE_LIMIT, 1e-6)
	for i in 100:
		_switches.change_exposure(-1)
	assert_almost_eq(_sky.exposure, -SkySwitches.EXPOSURE_LIMIT, 1e-6)


func test_the_hole_goes_and_comes_gradually() -> void:
	_switches.toggle_lensing()
	assert_false(_switches.is_hole_wanted())
	await wait_seconds(0.5 * SkySwitches.LENSING_SECONDS)
	assert_between(_sky.lensing, 0.05, 0.95, "on the way")
	_switches.toggle_lensing()
	var on_the_way := _sky.lensing
	await wait_seconds(1.2 * SkySwitches.LENSING_SECONDS)
	assert_true(_switches.is_hole_wanted())
	assert_gt(on_the_way, 0.0, "turned back on the way")
	assert_almost_eq(_sky.lensing, 1.0, 1e-6)
	_switches.toggle_lensing()
	await wait_seconds(1.2 * SkySwitches.LENSING_SECONDS)
	assert_almost_eq(_sky.lensing, 0.0, 1e-6)


func test_the_guide_speaks_once_for_each_way_in() -> void:
	var guide := HorizonGuide.new()
	autofree(guide)
	watch_signals(guide)
	guide.watch(1.5, ViewControls.Mode.ORBIT)
	assert_signal_not_emitted(guide, "advised")
	for distance: float in [0.5, 0.4, 0.3]:
		guide.watch(distance, ViewControls.Mode.ORBIT)
	assert_signal_emit_count(guide, "advised", 1)
	guide.watch(2.0, ViewControls.Mode.ORBIT)
	guide.watch(0.5, ViewControls.Mode.FLIGHT)
	assert_signal_emit_count(guide, "advised", 1, "a free flyer can turn round")
