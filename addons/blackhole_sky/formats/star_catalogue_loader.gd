# SPDX-License-Identifier: MIT
@tool
class_name StarCatalogueLoader
extends ResourceFormatLoader
## Lets the engine load `.stars` files as [StarCatalogue]: by [method @GDScript.load], in the
## inspector, in exports.


func _get_recognized_extensions() -> PackedStringArray:
	return ["stars"]


func _handles_type(type: StringName) -> bool:
	return ClassDB.is_parent_class(&"StarCatalogue", type)


func _get_resource_type(path: String) -> String:
	return "StarCatalogue" if path.get_extension().to_lower() == "stars" else ""


func _load(
	path: String, _original_path: String, _use_sub_threads: bool, _cache_mode: int
) -> Variant:
	var catalogue := StarCatalogue.new()
	var error := catalogue.load_file(path)
	if error != OK:
		return error
	return catalogue
