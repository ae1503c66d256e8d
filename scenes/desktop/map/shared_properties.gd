# SPDX-License-Identifier: MIT
class_name SharedProperties
extends RefCounted
## The stored properties of a class that one object takes over from another.

var _names := PackedStringArray()


## Those of `type` itself, not of its ancestors, and without `own`.
func _init(type: StringName, own: PackedStringArray) -> void:
	for property in ClassDB.class_get_property_list(type, true):
		var property_name: String = property["name"]
		var stored: int = property["usage"] & PROPERTY_USAGE_STORAGE
		if stored != 0 and not own.has(property_name):
			_names.append(property_name)


## Sets what differs.
func copy(from: Object, to: Object) -> void:
	for property in _names:
		var value: Variant = from.get(property)
		if to.get(property) != value:
			to.set(property, value)
