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
	guide.watch(2.0, ViewControls.Mode.RIDE)
	guide.watch(0.5, ViewControls.Mode.RIDE, ViewControls.Gaze.AWAY)
	assert_signal_emit_count(guide, "advised", 1, "who looks back sees the sky")
	guide.watch(2.0, ViewControls.Mode.RIDE)
	guide.watch(0.5, ViewControls.Mode.RIDE, ViewControls.Gaze.HOLE)
	assert_signal_emit_count(guide, "advised", 2)
