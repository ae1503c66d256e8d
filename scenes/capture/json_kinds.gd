# SPDX-License-Identifier: MIT
class_name JsonKinds
extends RefCounted
## Which of JSON's types a value has, when two values are the same, which types a schema lets in.

const ALL: PackedStringArray = ["null", "boolean", "integer", "number", "string", "array", "object"]
const DEFINITIONS: String = "#/$defs/"


## Whether a value has a type of JSON Schema. 3.0 is an integer; NaN and infinities are nothing.
static func is_type(value: Variant, type: String) -> bool:
	match type:
		"null":
			return value == null
		"boolean":
			return value is bool
		"integer":
			return is_number(value) and float(value) == roundf(value)
		"number":
			return is_number(value)
		"string":
			return value is String or value is StringName
		"array":
			return value is Array
		"object":
			return value is Dictionary
	return false


## Whether a value is a finite number.
static func is_number(value: Variant) -> bool:
	return (value is float and is_finite(value)) or value is int


## Whether JSON has such a value: its types only, keys that are strings, no NaN, no infinity, all
## the way down.
static func is_json(value: Variant) -> bool:
	if value is Array:
		var items: Array = value
		return items.all(is_json)
	if value is Dictionary:
		var object: Dictionary = value
		var named := func(key: Variant) -> bool: return is_type(key, "string")
		return object.keys().all(named) and object.values().all(is_json)
	return value == null or value is bool or is_number(value) or is_type(value, "string")


## Whether a value has lists and objects in each other, more than `levels` deep.
static func is_deeper(value: Variant, levels: int) -> bool:
	var level: Array = [value]
	for i in levels + 1:
		var below: Array = []
		for item: Variant in level:
			if item is Array:
				below.append_array(item)
			elif item is Dictionary:
				var object: Dictionary = item
				below.append_array(object.values())
		if below.is_empty():
			return false
		level = below
	return true


## Whether two values are the same to JSON: 1 and 1.0 are, 1 and true are not.
static func same(a: Variant, b: Variant) -> bool:
	if is_number(a) and is_number(b):
		return float(a) == float(b)
	if a is Array and b is Array:
		var list_a: Array = a
		var list_b: Array = b
		var equal := func(i: int) -> bool: return same(list_a[i], list_b[i])
		return list_a.size() == list_b.size() and range(list_a.size()).all(equal)
	if a is Dictionary and b is Dictionary:
		var object_a: Dictionary = a
		var object_b: Dictionary = b
		var equal := func(key: Variant) -> bool:
			return object_b.has(key) and same(object_a[key], object_b[key])
		return object_a.size() == object_b.size() and object_a.keys().all(equal)
	return typeof(a) == typeof(b) and a == b


## Whether two values are alike in type; JSON has one type of numbers.
static func same_kind(a: Variant, b: Variant) -> bool:
	return typeof(a) == typeof(b) or (is_number(a) and is_number(b))


## Whether one of `values` is the same as `value`.
static func has_same(values: Array, value: Variant) -> bool:
	return values.any(func(other: Variant) -> bool: return same(value, other))


## Where a list has an item that it has before. Each is looked up: to compare each with all others
## would take time as the square of thousands.
static func repeated(list: Array) -> PackedInt32Array:
	var places := PackedInt32Array()
	var plain: Dictionary = {}
	var texts: Dictionary = {}
	for i in list.size():
		var item: Variant = list[i]
		var known := plain
		var key: Variant = float(item) if is_number(item) else item
		if item is Array or item is Dictionary:
			known = texts
			# Twice, so that all numbers are of one type.
			key = JSON.stringify(JSON.parse_string(JSON.stringify(item)), "", true)
		if known.has(key):
			places.append(i)
		known[key] = true
	return places


## The types that a schema's own "type" names; all where it has none.
static func types(schema: Dictionary) -> PackedStringArray:
	if not schema.has("type"):
		return ALL
	var named: Variant = schema["type"]
	return PackedStringArray(named if named is Array else [named])


## The values that a schema's "const" or "enum" names; empty where it has neither.
static func named_values(schema: Dictionary) -> Array:
	return [schema["const"]] if schema.has("const") else schema.get("enum", [])


## What a schema's $ref names, in the end; the schema itself where it has none.
static func target(schema: Dictionary, definitions: Dictionary) -> Dictionary:
	while schema.has("$ref"):
		schema = referred(schema, definitions)
	return schema


## What a schema's $ref names.
static func referred(schema: Dictionary, definitions: Dictionary) -> Dictionary:
	var pointer: String = schema["$ref"]
	return definitions[pointer.trim_prefix(DEFINITIONS)]
