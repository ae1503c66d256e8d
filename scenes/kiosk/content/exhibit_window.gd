# SPDX-License-Identifier: MIT
class_name ExhibitWindow
extends Node
## Keeps the window as the exhibit needs it: over the whole of its screen, never closed, with words
## that are as large as the screen allows.


func _ready() -> void:
	get_tree().auto_accept_quit = false
	get_tree().quit_on_go_back = false
	get_window().size_changed.connect(fit)
	fit()


func _exit_tree() -> void:
	get_window().size_changed.disconnect(fit)
	get_window().content_scale_factor = 1.0
	get_tree().auto_accept_quit = true
	get_tree().quit_on_go_back = true


func _notification(what: int) -> void:
	if what == NOTIFICATION_WM_CLOSE_REQUEST:
		print("kiosk: somebody wanted to close the window")


## Takes the settings over.
func configure(config: KioskConfig) -> void:
	var window := get_window()
	var monitor := config.whole("monitor")
	if monitor >= DisplayServer.get_screen_count():
		push_warning(
			(
				"There is no screen %d, which monitor in %s names; the present one is taken."
				% [monitor, config.path]
			)
		)
	elif monitor >= 0:
		window.current_screen = monitor
	if config.flag("fullscreen"):
		window.mode = Window.MODE_EXCLUSIVE_FULLSCREEN


## Words keep their share of the window's height. What is shown sets this too, and undoes it.
func fit() -> void:
	get_window().content_scale_factor = PictureScale.text_scale(get_window().size)


## Takes the keys away that leave the program or its full screen.
func forbid_leaving() -> void:
	InputMap.action_erase_events(&"toggle_fullscreen")
