# SPDX-License-Identifier: MIT
@tool
extends EditorImportPlugin
## Imports a table of stars, a CSV file with the columns ra_deg, dec_deg and vmag, as a
## StarCatalogue.
##
## CSV files are translations to Godot until one says otherwise in the Import dock, hence the low
## priority.


func _get_importer_name() -> String:
	return "blackhole_sky.star_csv"


func _get_visible_name() -> String:
	return "Star Catalogue"


func _get_recognized_extensions() -> PackedStringArray:
	return ["csv"]


func _get_save_extension() -> String:
	return "stars"


func _get_resource_type() -> String:
	return "StarCatalogue"


func _get_priority() -> float:
	return 0.5


func _get_import_order() -> int:
	return ResourceImporter.IMPORT_ORDER_DEFAULT


func _get_preset_count() -> int:
	return 0


func _get_import_options(_path: String, _preset_index: int) -> Array[Dictionary]:
	return []


func _import(
	source_file: String,
	save_path: String,
	_options: Dictionary,
	_platform_variants: Array[String],
	_gen_files: Array[String]
) -> Error:
	var catalogue := StarCatalogue.new()
	var error := catalogue.load_file(source_file)
	if error != OK:
		return error  # load_file has named the line and the remedy
	return catalogue.save_file("%s.%s" % [save_path, _get_save_extension()])
