# SPDX-License-Identifier: MIT
extends GutTest
## The automatic exposure: darker skies and redshifted light ask for more, blueshifted light for
## less, and it follows in time.

const KEY: float = 0.004
const PIXELS := Vector2i(64, 32)

var _booth: SkyBooth
var _sky: BlackHoleSky


func before_each() -> void:
	_booth = SkyBooth.new()
	add_child_autofree(_booth)
	_sky = _booth.sky
	_sky.process_mode = Node.PROCESS_MODE_DISABLED
	_sky.lensing = 0.0
	_sky.auto_exposure = true
	_show_surface(Color(KEY, KEY, KEY))
	_look(10.0, Vector3.FORWARD)


## A sky of one colour, linear light.
func _show_surface(colour: Color) -> void:
	var picture := Image.create(PIXELS.x, PIXELS.y, false, Image.FORMAT_RGBF)
	picture.fill(colour)
	_sky.panorama = ImageTexture.create_from_image(picture)
	_sky.background = BlackHoleSky.BACKGROUND_PANORAMA


## From a place on the z axis, in Schwarzschild radii.
func _look(distance: float, towards: Vector3) -> void:
	_booth.camera.set_perspective(60.0, 0.05, 4000.0)
	_booth.camera.transform = Transform3D(Basis.looking_at(towards), Vector3(0, 0, distance))


func _adapted() -> float:
	_sky.adapt_at_once()
	return _sky.get_effective_exposure()


func test_a_uniform_sky_is_brought_to_the_key() -> void:
	assert_almost_eq(_adapted(), 0.0, 1e-3)
	_show_surface(Color(4.0 * KEY, 4.0 * KEY, 4.0 * KEY))
	assert_almost_eq(_adapted(), -2.0, 1e-3)
	_sky.panorama_luminance = 0.5
	assert_almost_eq(_adapted(), -1.0, 1e-3)


func test_pictures_of_eight_bits_hold_srgb() -> void:
	var picture := Image.create(PIXELS.x, PIXELS.y, false, Image.FORMAT_RGB8)
	picture.fill(Color(0.5, 0.5, 0.5))
	_sky.panorama = ImageTexture.create_from_image(picture)
	var linear := picture.get_pixel(0, 0).srgb_to_linear().r
	assert_almost_eq(_adapted(), log(KEY / linear) / log(2.0), 0.01)


func test_darker_skies_ask_for_more_within_limits() -> void:
	_show_surface(Color(KEY / 8.0, KEY / 8.0, KEY / 8.0))
	assert_almost_eq(_adapted(), 3.0, 1e-3)
	_sky.auto_exposure_max_ev = 2.0
	assert_almost_eq(_adapted(), 2.0, 1e-6)
	_sky.background = BlackHoleSky.BACKGROUND_NONE
	assert_almost_eq(_adapted(), 2.0, 1e-6, "black")
	_show_surface(Color.WHITE)
	_sky.auto_exposure_min_ev = -4.0
	assert_almost_eq(_adapted(), -4.0, 1e-6)


func test_exposure_is_the_compensation() -> void:
	_sky.exposure = 1.5
	assert_almost_eq(_adapted(), 1.5, 1e-3)
	_sky.auto_exposure = false
	assert_eq(_sky.get_effective_exposure(), 1.5)


func test_stars_count_while_they_are_shown() -> void:
	_sky.background = BlackHoleSky.BACKGROUND_NONE
	var catalogue := StarCatalogue.new()
	catalogue.load_file(SkyBooth.CATALOGUE_FILE)
	_sky.catalogue = catalogue
	var ev := _adapted()
	assert_between(ev, -2.0, 3.0)
	_sky.magnitude_limit = 3.0
	assert_gt(_adapted(), ev, "fewer stars")
	_sky.stars_visible = false
	assert_eq(_adapted(), _sky.auto_exposure_max_ev)


func test_blueshifted_light_near_the_horizon_asks_for_less() -> void:
	_sky.lensing = 1.0
	_look(100.0, Vector3.BACK)
	assert_almost_eq(_adapted(), 0.0, 0.1, "far away")
	_look(1.05, Vector3.BACK)
	var near := _adapted()
	assert_lt(near, -1.0, "static: frequencies times 4.6")
	_sky.panorama_is_light = false
	assert_gt(_adapted(), near + 1.0, "a chart is not shifted")


func test_what_was_just_turned_counts() -> void:
	var picture := Image.create(PIXELS.x, PIXELS.y, false, Image.FORMAT_RGBF)
	var half := Vector2i(PIXELS.x >> 1, PIXELS.y)
	picture.fill_rect(Rect2i(Vector2i.ZERO, half), Color(KEY, KEY, KEY))
	picture.fill_rect(Rect2i(Vector2i(half.x, 0), half), Color.WHITE)
	_sky.panorama = ImageTexture.create_from_image(picture)
	_look(10.0, Vector3.LEFT)
	var left := _adapted()
	_look(10.0, Vector3.RIGHT)
	var right := _adapted()
	assert_almost_eq(absf(left - right), log(1.0 / KEY) / log(2.0), 0.1, "the halves")
	_sky.rotation.y = PI
	assert_almost_eq(_adapted(), left, 0.01, "the sky turned round")


func test_the_shadow_asks_for_more() -> void:
	_sky.lensing = 1.0
	_look(3.0, Vector3.FORWARD)
	assert_between(_adapted(), 0.5, 5.5)


func test_without_a_hole_a_flight_shifts_the_light_ahead() -> void:
	_sky.observer_motion = LensingTable.MOTION_VELOCITY
	_sky.observer.celerity = Vector3(0, 0, -2)
	assert_lt(_adapted(), -0.5)
	_look(10.0, Vector3.BACK)
	assert_gt(_adapted(), 0.5)
	_sky.effect_doppler = false
	assert_almost_eq(_adapted(), 0.0, 1e-3)


func test_it_adapts_quickly_to_light_and_slowly_to_dark() -> void:
	assert_almost_eq(_adapted(), 0.0, 1e-3)
	_show_surface(Color(16.0 * KEY, 16.0 * KEY, 16.0 * KEY))
	_sky.adapt(0.0)
	assert_almost_eq(_sky.get_effective_exposure(), 0.0, 1e-3, "no time, no change")
	for step in 4:
		_sky.adapt(0.1)
	assert_almost_eq(_sky.get_effective_exposure(), -4.0 * (1.0 - exp(-1.0)), 1e-2)
	_adapted()
	_show_surface(Color(KEY, KEY, KEY))
	_sky.adapt(2.5)
	assert_almost_eq(_sky.get_effective_exposure(), -4.0 * exp(-1.0), 1e-2)
	_sky.adaptation_speed = 0.0
	_sky.adapt(1e-3)
	assert_almost_eq(_sky.get_effective_exposure(), 0.0, 1e-3, "at once")


func test_frames_adapt_a_node_that_processes() -> void:
	RenderingServer.frame_pre_draw.emit()
	assert_almost_eq(_sky.get_effective_exposure(), 0.0, 1e-3, "at rest")
	_show_surface(Color(16.0 * KEY, 16.0 * KEY, 16.0 * KEY))
	_sky.process_mode = Node.PROCESS_MODE_INHERIT
	for frame in 30:
		await wait_process_frames(1)
		RenderingServer.frame_pre_draw.emit()  # which a window that is drawn would do
	assert_lt(_sky.get_effective_exposure(), -0.1)


func test_without_automatic_or_camera_nothing_happens() -> void:
	_sky.auto_exposure = false
	_show_surface(Color.WHITE)
	assert_eq(_adapted(), 0.0)
	var alone: BlackHoleSky = autofree(BlackHoleSky.new())
	alone.auto_exposure = true
	alone.adapt_at_once()
	assert_eq(alone.get_effective_exposure(), 0.0)
