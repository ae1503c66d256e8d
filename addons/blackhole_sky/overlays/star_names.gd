# SPDX-License-Identifier: MIT
class_name StarNames
extends RefCounted
## Proper names of bright stars with their places, read from a table like the one in the addon's
## data.
##
## Comma-separated text; the first line is [code]hip,name,ra_deg,dec_deg,vmag[/code]: Hipparcos
## number, name, place in degrees at J2000.0, V magnitude. Brightest first.

## The names that come with the addon: all named stars down to magnitude 4.5.
const FILE: String = "res://addons/blackhole_sky/data/star_names.csv"
## Larger files are refused.
const MOST_BYTES: int = 4 << 20
const LONGEST_LINE: int = 1000
const _HEADER: PackedStringArray = ["hip", "name", "ra_deg", "dec_deg", "vmag"]
const _REMEDY: String = "Copy the file from the addon again; the class reference tells the format."

## Hipparcos numbers. All four lists are equally long, and empty when the file was refused.
var hips: PackedInt32Array
## Proper names.
var names: PackedStringArray
## Unit vectors.
var directions: PackedVector3Array
## V magnitudes, rising.
var magnitudes: PackedFloat32Array
## Why the file was refused, with the remedy; empty when it is fine.
var error: String = ""

var _path: String


## Reads a file. The result is never null: see [member error].
static func load_file(path: String = FILE) -> StarNames:
	var loaded := StarNames.new()
	loaded._path = path
	var text := BoundedText.from_file(path, MOST_BYTES)
	if text.error.is_empty():
		loaded._check_lines(text.text)
		if loaded.error.is_empty():
			loaded._read(FileAccess.open(path, FileAccess.READ))
	else:
		var hint := "; in an export, whether its import type is 'Keep File'."
		loaded.error = "Star name file %s %s" % [path, text.error.trim_suffix(".") + hint]
	if not loaded.error.is_empty():
		loaded._clear()
	return loaded


## How many of the first stars are at least as bright as a magnitude.
func count_to(magnitude: float) -> int:
	return magnitudes.bsearch(magnitude, false)


## Each star has a line of its own, and no long one. The engine would look for the end of a quote in
## all lines that follow, and takes time as the square of what it reads.
func _check_lines(text: String) -> void:
	var line := 0
	for written in text.split("\n"):
		line += 1
		if written.length() > LONGEST_LINE:
			_refuse("line %d is longer than %d characters" % [line, LONGEST_LINE])
		elif written.count('"') % 2 == 1:
			_refuse("line %d has a quote that is not closed" % line)
		if not error.is_empty():
			return


func _read(file: FileAccess) -> void:
	if file.get_csv_line() != _HEADER:
		_refuse("its first line is not %s" % ",".join(_HEADER))
		return
	var line := 1
	while file.get_position() < file.get_length() and error.is_empty():
		line += 1
		_read_star(file.get_csv_line(), line)
	if names.is_empty():
		_refuse("it names no star")


func _read_star(cells: PackedStringArray, line: int) -> void:
	if cells.size() != _HEADER.size():
		_refuse("line %d has %d values instead of %d" % [line, cells.size(), _HEADER.size()])
		return
	var is_number := cells[0].is_valid_int() and cells[0].length() < 10
	if not is_number or cells[0].to_int() <= 0 or cells[1].is_empty():
		_refuse("line %d lacks a Hipparcos number or a name" % line)
		return
	for cell in cells.slice(2):
		if not cell.is_valid_float() or not is_finite(cell.to_float()):
			_refuse("line %d: '%s' is no number" % [line, cell])
			return
	if not SkyAxes.is_place(cells[2].to_float(), cells[3].to_float()):
		_refuse("line %d: %s, %s is no place in degrees" % [line, cells[2], cells[3]])
		return
	var magnitude := cells[4].to_float()
	if absf(magnitude) > 50.0:
		_refuse("line %d: %s is no magnitude of a star" % [line, cells[4]])
		return
	if not magnitudes.is_empty() and magnitude < magnitudes[-1] - 1e-5:
		_refuse("line %d is brighter than the line before it" % line)
		return
	hips.append(cells[0].to_int())
	names.append(cells[1])
	directions.append(SkyAxes.direction(cells[2].to_float(), cells[3].to_float()))
	magnitudes.append(magnitude)


func _clear() -> void:
	hips.clear()
	names.clear()
	directions.clear()
	magnitudes.clear()


func _refuse(reason: String) -> void:
	if error.is_empty():
		error = "Star name file %s cannot be used: %s. %s" % [_path, reason, _REMEDY]
