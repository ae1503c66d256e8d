# SPDX-License-Identifier: MIT
@tool
class_name LensingTableLoader
extends ResourceFormatLoader
## Lets the engine load `.lut` files as [LensingTable]: by [method @GDScript.load], in the
## inspector, in exports.


func _get_recognized_extensions() -> PackedStringArray:
	return ["lut"]


func _handles_type(type: StringName) -> bool:
	return ClassDB.is_parent_class(&"LensingTable", type)


func _get_resource_type(path: String) -> String:
	return "LensingTable" if path.get_extension().to_lower() == "lut" else ""


func _load(
	path: String, _original_path: String, _use_sub_threads: bool, _cache_mode: int
) -> Variant:
	var table := LensingTable.new()
	var error := table.load_file(path)
	if error != OK:
		return error
	return table
