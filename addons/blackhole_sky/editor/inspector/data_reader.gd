# SPDX-License-Identifier: MIT
@tool
extends RefCounted
## Reads the files of a sky, a table or a catalogue again, so that everything that is made from them
## is made anew.

const TableBaker := preload("../table_baker.gd")


## Nothing becomes of a file that cannot be read but its message: what was there stays.
static func read_anew(object: Object) -> void:
	if object is BlackHoleSky:
		var sky: BlackHoleSky = object
		for part: Object in [sky.table, sky.catalogue]:
			if part != null:
				read_anew(part)
	elif object is LensingTable:
		var table: LensingTable = object
		var path := TableBaker.file_of(table)
		if path.is_empty():
			table.emit_changed()
		else:
			table.load_file(path)
	elif object is StarCatalogue:
		var catalogue: StarCatalogue = object
		if catalogue.source_file.is_empty():
			catalogue.emit_changed()
		else:
			catalogue.load_file(catalogue.source_file)
