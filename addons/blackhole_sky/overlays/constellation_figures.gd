# SPDX-License-Identifier: MIT
class_name ConstellationFigures
extends RefCounted
## Names and lines of the constellations, read from a JSON file like the one in the addon's data.
##
## The file is an object with the list [code]constellations[/code]; each of them has
## [code]id[/code] (the IAU's abbreviation), its names [code]la[/code] and [code]de[/code],
## [code]labels[/code] (places of its name; Serpens has two) and [code]lines[/code] (lists of two
## or more places). A place is [code][ra, dec][/code] in degrees, at J2000.0.


## One constellation.
class Figure:
	extends RefCounted
	## The IAU's abbreviation, such as [code]UMa[/code].
	var id: String
	## Where the name may stand, unit vectors; at least one.
	var labels: PackedVector3Array
	## The lines of the figure: unit vectors, joined by arcs of great circles.
	var lines: Array[PackedVector3Array] = []

	var _names: Dictionary[String, String] = {}

	## The name in a language, such as [code]de[/code] or [code]de_AT[/code]; in Latin where there
	## is none.
	func name(language: String) -> String:
		return _names.get(language.get_slice("_", 0).to_lower(), _names["la"])


## The figures that come with the addon.
const FILE: String = "res://addons/blackhole_sky/data/constellations.json"
## Larger files are refused.
const MOST_BYTES: int = 4 << 20
const _LANGUAGES: PackedStringArray = ["la", "de"]
const _REMEDY: String = "Copy the file from the addon again; the class reference tells the format."

## All constellations in the file's order; empty when the file was refused.
var figures: Array[Figure] = []
## Why the file was refused, with the remedy; empty when it is fine.
var error: String = ""

var _path: String


## Reads a file. The result is never null: see [member error].
static func load_file(path: String = FILE) -> ConstellationFigures:
	var loaded := ConstellationFigures.new()
	loaded._path = path
	var file := BoundedText.from_file(path, MOST_BYTES)
	if file.error.is_empty():
		loaded._read(file.text)
	else:
		loaded.error = "Constellation file %s %s" % [path, file.error]
	if not loaded.error.is_empty():
		loaded.figures = []
	return loaded


## The figure with this abbreviation; null when there is none.
func find(id: String) -> Figure:
	for figure in figures:
		if figure.id == id:
			return figure
	return null


func _read(text: String) -> void:
	var parser := JSON.new()
	if parser.parse(text) != OK:
		_refuse(
			"line %d is no JSON: %s" % [parser.get_error_line() + 1, parser.get_error_message()]
		)
		return
	var rows: Variant = parser.data.get("constellations") if parser.data is Dictionary else null
	if rows is not Array or (rows as Array).is_empty():
		_refuse("it has no list 'constellations'")
		return
	for row: Variant in rows:
		_read_figure(row)


func _read_figure(row: Variant) -> void:
	var place := "constellation %d" % (figures.size() + 1)
	if row is not Dictionary:
		_refuse("%s is not an object" % place)
		return
	var figure := Figure.new()
	figure.id = _text(row, "id", place)
	if find(figure.id) != null:
		_refuse("'%s' comes twice" % figure.id)
	place = "%s ('%s')" % [place, figure.id]
	for language in _LANGUAGES:
		figure._names[language] = _text(row, language, place)
	figure.labels = _places(row.get("labels"), 1, "the labels of %s" % place)
	var lines: Variant = row.get("lines")
	if lines is not Array or (lines as Array).is_empty():
		_refuse("%s has no list 'lines'" % place)
		return
	for line: Variant in lines:
		figure.lines.append(_places(line, 2, "a line of %s" % place))
	figures.append(figure)


func _text(row: Dictionary, key: String, owner: String) -> String:
	var value: Variant = row.get(key)
	if value is String and not (value as String).is_empty():
		return value
	_refuse("%s has no text '%s'" % [owner, key])
	return ""


func _places(list: Variant, least: int, what: String) -> PackedVector3Array:
	var directions := PackedVector3Array()
	if list is not Array or (list as Array).size() < least:
		_refuse("%s must be a list of at least %d [ra, dec]" % [what, least])
		return directions
	for pair: Variant in list:
		if not _is_pair(pair):
			_refuse("%s: %s is no [ra, dec] in degrees" % [what, JSON.stringify(pair)])
			return directions
		directions.append(SkyAxes.direction(pair[0], pair[1]))
	return directions


func _is_pair(pair: Variant) -> bool:
	if pair is not Array or (pair as Array).size() != 2:
		return false
	return pair[0] is float and pair[1] is float and SkyAxes.is_place(pair[0], pair[1])


func _refuse(reason: String) -> void:
	if error.is_empty():
		error = "Constellation file %s cannot be used: %s. %s" % [_path, reason, _REMEDY]
