# SPDX-License-Identifier: MIT
@tool
extends RefCounted
## The page `blackhole_sky` of the project settings: what skies get that are newly added in the
## editor.
##
## A setting that equals its default is written into no file and goes with the plugin.

const GIVE_DATA: String = "blackhole_sky/new_skies/give_data"
const TABLE: String = "blackhole_sky/new_skies/table"
const CATALOGUE: String = "blackhole_sky/new_skies/catalogue"
const PANORAMA: String = "blackhole_sky/new_skies/panorama"
const PANORAMA_LUMINANCE: String = "blackhole_sky/new_skies/panorama_luminance"
const EXPOSURE: String = "blackhole_sky/new_skies/exposure"
const MAGNITUDE_LIMIT: String = "blackhole_sky/new_skies/magnitude_limit"

const _DATA: String = "res://addons/blackhole_sky/data/"
const _DEFAULTS: Dictionary[String, Variant] = {
	GIVE_DATA: true,
	TABLE: _DATA + "schwarzschild.lut",
	CATALOGUE: _DATA + "hipparcos.stars",
	PANORAMA: MilkyWay.FILE,
	PANORAMA_LUMINANCE: MilkyWay.LUMINANCE,
	EXPOSURE: 2.0,
	MAGNITUDE_LIMIT: 12.0,
}
## Hint and its text; those left out are switches.
const _HINTS: Dictionary[String, Array] = {
	TABLE: [PROPERTY_HINT_FILE, "*.lut,*.tres,*.res"],
	CATALOGUE: [PROPERTY_HINT_FILE, "*.stars,*.csv,*.tres,*.res"],
	PANORAMA: [PROPERTY_HINT_FILE, "*.exr,*.hdr,*.png,*.jpg,*.webp,*.tres"],
	PANORAMA_LUMINANCE: [PROPERTY_HINT_RANGE, "0,10,0.001,or_greater"],
	EXPOSURE: [PROPERTY_HINT_RANGE, "-10,10,0.1,or_less,or_greater,suffix:EV"],
	MAGNITUDE_LIMIT: [PROPERTY_HINT_RANGE, "-2,15,0.1,or_greater,suffix:mag"],
}
const _BASIC: Array[String] = [GIVE_DATA, TABLE, CATALOGUE, PANORAMA]


## Puts the settings onto the page.
static func add() -> void:
	for setting: String in _DEFAULTS:
		if not ProjectSettings.has_setting(setting):
			ProjectSettings.set_setting(setting, _DEFAULTS[setting])
		ProjectSettings.set_initial_value(setting, _DEFAULTS[setting])
		ProjectSettings.set_as_basic(setting, setting in _BASIC)
		var hint: Array = _HINTS.get(setting, [PROPERTY_HINT_NONE, ""])
		(
			ProjectSettings
			. add_property_info(
				{
					"name": setting,
					"type": typeof(_DEFAULTS[setting]),
					"hint": hint[0],
					"hint_string": hint[1],
				}
			)
		)


## Takes those away that nobody has changed; the others are the project's.
static func remove() -> void:
	for setting: String in _DEFAULTS:
		if value(setting) == _DEFAULTS[setting]:
			ProjectSettings.set_setting(setting, null)


## What a setting is, or would be by default.
static func value(setting: String) -> Variant:
	return ProjectSettings.get_setting(setting, _DEFAULTS[setting])
