# SPDX-License-Identifier: MIT
class_name CreditsText
extends RefCounted
## Who and what the program is made of, for the credits' page and for the headset's menu.

const STARS: PackedStringArray = [
	"ESA 1997, The Hipparcos and Tycho Catalogues, ESA SP-1200.",
	"F. van Leeuwen 2007, Astronomy & Astrophysics 474, 653 (CDS I/311).",
]
const MAGNITUDES: PackedStringArray = [
	"XHIP: E. Anderson & C. Francis 2012, Astronomy Letters 38, 331 (CDS V/137D).",
	"d3-celestial: © 2015 Olaf Frohn, BSD-3-Clause.",
]
const MILKY_WAY: PackedStringArray = [
	"“Modify and redistribute this image",
	"if proper credit to the original image is given.”",
]
const ENGINE: PackedStringArray = [
	"Godot Engine %s, MIT.",
	"© 2014-present Godot Engine contributors.",
	"© 2007-2014 Juan Linietsky, Ariel Manzur.",
]
const LIBRARIES: PackedStringArray = [
	"GLM (MIT) · Boost.Math (BSL-1.0) · zlib (zlib)",
	"CIE 1931: colour-science (BSD-3-Clause)",
]
const D3_CELESTIAL: String = "Copyright (c) 2015, Olaf Frohn\nBSD-3-clause, below"


## Everything to be named, in order.
static func entries() -> Array[CreditsEntry]:
	return [
		_entry(_translated("Program"), [_program(), _translated("The authors of blackhole_sky.")]),
		_entry(
			_translated("Idea"),
			[
				_translated(
					"The project takes up the master thesis of N.-C. Popst (LMU Munich, 2021)."
				),
				_translated(
					"It drew such a sky with OpenGL, from the tables of T. Müller's 2D program."
				),
			]
		),
		_entry(
			_translated("Stars"),
			_joined(_translated("118,217 stars that the satellite Hipparcos measured."), STARS)
		),
		_entry(_translated("Magnitudes and names of the stars"), MAGNITUDES),
		_entry(
			_translated("Constellations"),
			[
				MAGNITUDES[1],
				_translated("Lines after the International Astronomical Union."),
				_translated("Names in other languages after Wikipedia."),
			]
		),
		_entry(
			_translated("Milky Way"),
			[
				_translated(
					"Panorama by Axel Mellinger, as distributed with Stellarium; smoothed."
				),
				" ".join(MILKY_WAY),
			]
		),
		_entry(_translated("Engine"), [ENGINE[0] % _engine_version(), ENGINE[1], ENGINE[2]]),
		_entry(_translated("Font"), [_translated("%s, as it comes with the engine.") % _font()]),
		_entry(_translated("Libraries"), LIBRARIES),
	]


## The licences in full, in the English in which they hold.
static func licences() -> Array[CreditsEntry]:
	var listed: Array[CreditsEntry] = [
		CreditsEntry.new("Godot Engine", Engine.get_license_text()),
		CreditsEntry.new("d3-celestial", D3_CELESTIAL),
	]
	for component: Dictionary in Engine.get_copyright_info():
		var name: String = component["name"]
		listed.append(CreditsEntry.new(name, _component_text(component)))
	var texts := Engine.get_license_info()
	for name: String in texts:
		var text: String = texts[name]
		listed.append(CreditsEntry.new(name, text))
	return listed


static func _program() -> String:
	var name: String = ProjectSettings.get_setting("application/config/name", "")
	return "%s %s, MIT." % [name, ProgramVersion.text()]


static func _component_text(component: Dictionary) -> String:
	var lines := PackedStringArray()
	for part: Dictionary in component["parts"]:
		for holder: String in part["copyright"]:
			lines.append("© " + holder)
		lines.append("Licence: %s" % part["license"])
	return "\n".join(lines)


static func _engine_version() -> String:
	var version := Engine.get_version_info()
	return "%d.%d.%d" % [version["major"], version["minor"], version["patch"]]


static func _font() -> String:
	return ThemeDB.fallback_font.get_font_name()


static func _joined(first: String, rest: PackedStringArray) -> PackedStringArray:
	return PackedStringArray([first]) + rest


static func _entry(title: String, lines: PackedStringArray) -> CreditsEntry:
	return CreditsEntry.new(title, "\n".join(lines))


static func _translated(text: String) -> String:
	return TranslationServer.translate(text)
