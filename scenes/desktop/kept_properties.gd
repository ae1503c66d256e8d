# SPDX-License-Identifier: MIT
class_name KeptProperties
extends RefCounted
## Properties of nodes as they were, to be put back.

var _objects: Array[Object] = []
var _names: Array[StringName] = []
var _values: Array[Variant] = []


func keep(object: Object, properties: Array[StringName]) -> void:
	for property in properties:
		_objects.append(object)
		_names.append(property)
		_values.append(object.get(property))


## Puts back what is still there, in the order in which it was kept.
func restore() -> void:
	for i in _objects.size():
		if is_instance_valid(_objects[i]):
			_objects[i].set(_names[i], _values[i])
	_objects.clear()
	_names.clear()
	_values.clear()
