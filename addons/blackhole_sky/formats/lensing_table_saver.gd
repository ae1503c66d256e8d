# SPDX-License-Identifier: MIT
@tool
class_name LensingTableSaver
extends ResourceFormatSaver
## Lets the engine save a [LensingTable] as a `.lut` file.


func _recognize(resource: Resource) -> bool:
	return resource is LensingTable


func _get_recognized_extensions(resource: Resource) -> PackedStringArray:
	return ["lut"] if resource is LensingTable else []


func _save(resource: Resource, path: String, _flags: int) -> Error:
	var table: LensingTable = resource
	return table.save_file(path)
