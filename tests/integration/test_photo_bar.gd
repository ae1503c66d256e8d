# SPDX-License-Identifier: MIT
extends "res://tests/integration/desktop_test.gd"
## The photo mode's bar over the desktop scene: reached and used by keys and by a gamepad alone;
## what it changes is put back.

const NAMES: PackedStringArray = [
	"Exposure", "FieldOfView", "Roll", "Stars", "Size", "Thirds", "SavePng", "SaveExr", "Done"
]

var _photo: PhotoMode
var _frame: Control


func before_each() -> void:
	super()
	_frame = _scene.get_node("%Frame")
	_photo = _scene.get_node("%PhotoMode")
	_photo.open()


func _widget(widget_name: String) -> Control:
	return _photo.get_node("%" + widget_name)


func _key(key: Key) -> void:
	_press(_key_event(key))


func _button(button: JoyButton) -> void:
	_press(_button_event(button))


func test_down_reaches_everything(is_gamepad: bool = use_parameters([false, true])) -> void:
	for widget in NAMES:
		assert_true(_widget(widget).has_focus(), "%s has the focus" % widget)
		if is_gamepad:
			_button(JOY_BUTTON_DPAD_DOWN)
		else:
			_key(KEY_DOWN)
	assert_true(_widget(NAMES[0]).has_focus(), "and round")


func test_values_are_changed_by_keys() -> void:
	var exposure := _sky.exposure
	_key(KEY_RIGHT)
	assert_almost_eq(_sky.exposure, exposure + 0.25, 1e-5)
	_key(KEY_DOWN)
	_key(KEY_LEFT)
	assert_almost_eq(_photo.camera.fov, 69.0, 1e-4)
	_key(KEY_DOWN)
	var roll := CameraRoll.of(_photo.camera.global_basis)
	(_photo.get_node("%Bar") as PhotoBar).refresh()
	_key(KEY_RIGHT)
	assert_almost_eq(CameraRoll.of(_photo.camera.global_basis), roll + 1.0, 0.51)
	_key(KEY_DOWN)
	_key(KEY_RIGHT)
	assert_eq(_sky.psf_model, BlackHoleSky.PSF_AIRY)


func test_by_gamepad_too() -> void:
	var exposure := _sky.exposure
	_button(JOY_BUTTON_DPAD_LEFT)
	assert_almost_eq(_sky.exposure, exposure - 0.25, 1e-5)
	for down in NAMES.find("Thirds"):
		_button(JOY_BUTTON_DPAD_DOWN)
	_button(JOY_BUTTON_A)
	assert_true(_widget("Grid").visible)
	_button(JOY_BUTTON_B)
	assert_false(_photo.visible)


func test_the_bar_goes_and_comes_and_the_camera_moves_without_it() -> void:
	assert_false(_controls.keys_listening)
	_key(KEY_H)
	assert_false(_photo.is_bar_shown())
	assert_true(_controls.keys_listening)
	assert_false(_help.visible, "the key means nothing else")
	var background := _sky.background
	_button(JOY_BUTTON_Y)
	assert_true(_photo.is_bar_shown())
	assert_eq(_sky.background, background, "nor does the button")
	_button(JOY_BUTTON_Y)
	_key(KEY_ESCAPE)
	assert_true(_photo.visible, "first the bar comes back")
	assert_true(_photo.is_bar_shown())
	_key(KEY_ESCAPE)
	assert_false(_photo.visible)


func test_what_was_changed_is_put_back() -> void:
	_photo.close()
	_sky.auto_exposure = true
	_sky.exposure = 0.5
	var map: MapWindow = _scene.get_node("%Map")
	map.open()
	_photo.open()
	assert_false(_frame.visible)
	assert_false(map.visible)
	assert_false(_sky.auto_exposure, "what was metered last stays")
	assert_eq(_photo.camera.projection, Camera3D.PROJECTION_PERSPECTIVE)
	_sky.exposure = 4.0
	_photo.camera.fov = 20.0
	_sky.psf_model = BlackHoleSky.PSF_EYE
	_photo.close()
	assert_true(_frame.visible)
	assert_true(map.visible)
	assert_true(_sky.auto_exposure)
	assert_almost_eq(_sky.exposure, 0.5, 1e-5)
	assert_almost_eq(_photo.camera.fov, 70.0, 1e-4)
	assert_eq(_sky.psf_model, BlackHoleSky.PSF_GAUSSIAN)
	assert_true(_controls.keys_listening)
	map.close()


func test_time_stands_still() -> void:
	var disk: AccretionDisk = _scene.get_node("Sky/Disk")
	var clock: Node = _scene.get_node("DiskClock")
	assert_eq(disk.time_scale, 0.0)
	assert_false(clock.is_processing())
	_photo.close()
	assert_true(clock.is_processing())


func test_other_keys_rest() -> void:
	var orders := _sky.image_orders
	_key(KEY_I)
	assert_eq(_sky.image_orders, orders)
	_photo.close()
	_key(KEY_I)
	assert_ne(_sky.image_orders, orders)


func test_it_fits_a_narrow_window_in_both_languages(
	locale: String = use_parameters(["en", "de"])
) -> void:
	TranslationServer.set_locale(locale)
	var bar: Control = _photo.get_node("%Bar")
	await wait_process_frames(3)
	(bar as PhotoBar).refresh()
	assert_lte(bar.get_combined_minimum_size().x, 1232.0)
	TranslationServer.set_locale("en")
