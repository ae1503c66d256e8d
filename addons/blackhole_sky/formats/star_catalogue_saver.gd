# SPDX-License-Identifier: MIT
@tool
class_name StarCatalogueSaver
extends ResourceFormatSaver
## Lets the engine save a [StarCatalogue] as a `.stars` file.


func _recognize(resource: Resource) -> bool:
	return resource is StarCatalogue


func _get_recognized_extensions(resource: Resource) -> PackedStringArray:
	return ["stars"] if resource is StarCatalogue else []


func _save(resource: Resource, path: String, _flags: int) -> Error:
	var catalogue: StarCatalogue = resource
	return catalogue.save_file(path)
