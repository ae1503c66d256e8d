# SPDX-License-Identifier: MIT
extends SettingsCase
## What the settings do to a real window.


func after_each() -> void:
	super()
	get_window().mode = Window.MODE_WINDOWED


func test_waiting_for_the_screen() -> void:
	DisplayServer.window_set_vsync_mode(DisplayServer.VSYNC_ENABLED)
	if DisplayServer.window_get_vsync_mode() != DisplayServer.VSYNC_ENABLED:
		pending("this driver does not wait for the screen")
		return
	_settings.set_value(&"vsync", false)
	assert_eq(DisplayServer.window_get_vsync_mode(), DisplayServer.VSYNC_DISABLED)
	_settings.set_value(&"vsync", true)
	assert_eq(DisplayServer.window_get_vsync_mode(), DisplayServer.VSYNC_ENABLED)


func test_full_screen() -> void:
	_settings.set_value(&"fullscreen", true)
	assert_eq(get_window().mode, Window.MODE_FULLSCREEN)
	_settings.set_value(&"fullscreen", false)
	assert_eq(get_window().mode, Window.MODE_WINDOWED)
