# SPDX-License-Identifier: MIT
class_name SettingList
extends RefCounted
## All that a user can set, page by page. The first values are those that the scenes have by
## themselves.

const PICTURE: StringName = &"picture"
const SOUND: StringName = &"sound"
const CONTROLS: StringName = &"controls"
const LANGUAGE: StringName = &"language"
const ACCESSIBILITY: StringName = &"accessibility"
## In the order of the tabs.
const PAGES: Array[StringName] = [PICTURE, SOUND, CONTROLS, LANGUAGE, ACCESSIBILITY]

const BINDINGS: StringName = &"bindings"
## The language of the system, unless the program was started with another.
const SYSTEM_LANGUAGE: String = "system"

static var _pages: Dictionary[StringName, Array] = {}
static var _by_key: Dictionary[StringName, Setting] = {}


## The settings of a page, in order.
static func of_page(page: StringName) -> Array[Setting]:
	_make()
	var listed: Array[Setting] = []
	listed.assign(_pages[page])
	return listed


static func keys() -> Array[StringName]:
	_make()
	return _by_key.keys()


## The setting of this name; null when there is none.
static func find(key: StringName) -> Setting:
	_make()
	return _by_key.get(key)


static func _make() -> void:
	if not _pages.is_empty():
		return
	_pages = {
		PICTURE: _picture(),
		SOUND: _sound(),
		CONTROLS: _controls(),
		LANGUAGE: _language(),
		ACCESSIBILITY: _accessibility(),
	}
	for page in PAGES:
		for setting: Setting in _pages[page]:
			_by_key[setting.key] = setting


static func _picture() -> Array[Setting]:
	return [
		Setting.choice(
			&"quality",
			"Quality",
			"high",
			{"low": "Low", "medium": "Medium", "high": "High"},
			"Low: fewer pixels, one image of each star, no faint stars. Medium: no faint stars."
		),
		Setting.number(&"field_of_view", "Field of view", 70.0, Vector3(40, 110, 5), "%d°"),
		Setting.on_off(&"fullscreen", "Full screen", false),
		Setting.on_off(
			&"vsync",
			"Vertical sync",
			true,
			"Avoids torn pictures: as many frames a second as the screen shows."
		),
		(
			Setting
			. choice(
				&"frame_limit",
				"Frame limit",
				"none",
				{
					"none": "No limit",
					"30": "30",
					"60": "60",
					"90": "90",
					"120": "120",
					"144": "144",
				},
				"A limit saves power and keeps a fan quiet."
			)
		),
	]


static func _sound() -> Array[Setting]:
	return [
		Setting.number(&"volume", "Volume", 100.0, Vector3(0, 100, 5), "%d %%"),
		Setting.on_off(&"mute", "Mute", false),
		Setting.on_off(&"mono", "Mono", false, "Both ears hear the same."),
	]


static func _controls() -> Array[Setting]:
	return [
		Setting.number(
			&"mouse_sensitivity", "Speed of the mouse", 100.0, Vector3(20, 300, 10), "%d %%"
		),
		Setting.number(
			&"stick_sensitivity", "Speed of sticks and keys", 100.0, Vector3(20, 300, 10), "%d %%"
		),
		Setting.number(
			&"stick_dead_zone",
			"Dead zone of the sticks",
			20.0,
			Vector3(5, 60, 5),
			"%d %%",
			"More of it when the view moves though nobody touches the stick."
		),
		Setting.on_off(&"invert_y", "Up and down the other way round", false),
		(
			Setting
			. choice(
				&"fast_mode",
				"Flying faster",
				"hold",
				{"hold": "While held", "toggle": "On and off"},
			)
		),
		Setting.bindings(BINDINGS),
	]


static func _language() -> Array[Setting]:
	return [
		(
			Setting
			. choice(
				&"language",
				"Language",
				SYSTEM_LANGUAGE,
				{SYSTEM_LANGUAGE: "As the system", "en": "English", "de": "Deutsch"},
			)
		),
	]


static func _accessibility() -> Array[Setting]:
	return [
		Setting.number(&"text_size", "Size of text", 100.0, Vector3(100, 150, 10), "%d %%"),
		Setting.on_off(
			&"high_contrast",
			"High contrast",
			false,
			"White text on black panels, with bright borders."
		),
		(
			Setting
			. on_off(
				&"reduced_motion",
				"Less motion",
				false,
				"The view stops at once, the hole comes and goes without growing, the disk turns slowly."
			)
		),
		Setting.on_off(&"captions", "Captions", true, "The words of the guided tour."),
		Setting.number(&"caption_size", "Size of captions", 100.0, Vector3(80, 200, 10), "%d %%"),
	]
