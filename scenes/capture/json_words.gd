# SPDX-License-Identifier: MIT
class_name JsonWords
extends RefCounted
## JSON values and what a schema allows, in words for messages.

const LONGEST_VALUE: int = 48
const TYPES: Dictionary[String, String] = {
	"null": "null",
	"boolean": "true or false",
	"integer": "a whole number",
	"number": "a number",
	"string": "a string",
	"array": "a list",
	"object": "a JSON object",
}


## A value as JSON writes it, cut short where it is long.
static func value(shown: Variant) -> String:
	var text := _whole_value(shown, 0)
	return text if text.length() <= LONGEST_VALUE else text.left(LONGEST_VALUE - 3) + "..."


## Names as one reads them in a list; strings without their quotes.
static func names(values: Array) -> String:
	var texts: PackedStringArray = []
	for item: Variant in values:
		texts.append(str(item) if item is String or item is StringName else value(item))
	return ", ".join(texts)


## What a schema asks for, to stand after "must be". `definitions` are what its $ref name; a `brief`
## text says of lists no more than that they are lists.
static func expected(schema: Dictionary, definitions: Dictionary, brief: bool = false) -> String:
	if schema.has("const"):
		return value(schema["const"])
	if schema.has("enum"):
		var allowed: Array = schema["enum"]
		return "one of: " + names(allowed)
	if schema.has("pattern"):
		return schema.get("description", "a string that matches %s" % schema["pattern"])
	if schema.has("type"):
		var texts: PackedStringArray = []
		for type in JsonKinds.types(schema):
			if type == "array" and not brief:
				texts.append(_list(schema, definitions))
			else:
				texts.append(_single(type, schema))
		return " or ".join(texts)
	for keyword: String in ["oneOf", "anyOf"]:
		if schema.has(keyword):
			var branches: Array = schema[keyword]
			return alternatives(branches, definitions, brief)
	if schema.has("$ref"):
		return expected(JsonKinds.target(schema, definitions), definitions, brief)
	return "allowed by the schema"


## What several schemas ask for, one of which is to be met.
static func alternatives(branches: Array, definitions: Dictionary, brief: bool = false) -> String:
	var texts: PackedStringArray = []
	var lists := false
	for branch: Dictionary in branches:
		var text := expected(branch, definitions, brief)
		lists = lists or text.begins_with("one of: ")
		if not texts.has(text):
			texts.append(text)
	return ("; or " if lists else " or ").join(texts)


static func _single(type: String, schema: Dictionary) -> String:
	match type:
		"number", "integer":
			return TYPES[type] + _range(schema)
		"string":
			var shortest := int(float(schema.get("minLength", 0)))
			if shortest > 1:
				return "a string of at least %d characters" % shortest
			return "a string that is not empty" if shortest == 1 else "a string"
	return TYPES[type]


static func _range(schema: Dictionary) -> String:
	if schema.has("minimum") and schema.has("maximum"):
		return " from %s to %s" % [value(schema["minimum"]), value(schema["maximum"])]
	var bounds: PackedStringArray = []
	for bound: PackedStringArray in [
		["minimum", "of at least"],
		["exclusiveMinimum", "greater than"],
		["maximum", "of at most"],
		["exclusiveMaximum", "less than"],
	]:
		if schema.has(bound[0]):
			bounds.append(" %s %s" % [bound[1], value(schema[bound[0]])])
	return " and".join(bounds)


static func _list(schema: Dictionary, definitions: Dictionary) -> String:
	var least := int(float(schema.get("minItems", 0)))
	var most := int(float(schema.get("maxItems", -1)))
	var count := ""
	if least == most:
		count = " %d" % least
	elif least > 0 and most > 0:
		count = " %d to %d" % [least, most]
	elif least > 0:
		count = " at least %d" % least
	elif most > 0:
		count = " at most %d" % most
	var different := " different" if schema.get("uniqueItems", false) else ""
	var each := " values"
	if schema.has("items"):
		var items: Dictionary = schema["items"]
		each = " " + _plural(expected(items, definitions, true))
	if (count + different).is_empty() and not schema.has("items"):
		return "a list"
	return "a list of%s%s%s" % [count, different, each]


static func _plural(text: String) -> String:
	if text.begins_with("one of: "):
		return "values out of: " + text.trim_prefix("one of: ")
	for single: String in ["number", "string", "list", "object"]:
		text = text.replace(single, single + "s")
	return text.trim_prefix("a ")


static func _whole_value(shown: Variant, depth: int) -> String:
	if depth > LONGEST_VALUE:
		return "..."
	if shown is float or shown is int:
		var number: float = shown
		return "%d" % number if absf(number) < 1e15 and number == roundf(number) else str(number)
	var texts: PackedStringArray = []
	if shown is Array:
		var items: Array = shown
		for item: Variant in items:
			texts.append(_whole_value(item, depth + 1))
		return "[%s]" % ", ".join(texts)
	if shown is Dictionary:
		var object: Dictionary = shown
		for key: Variant in object:
			texts.append(
				"%s: %s" % [JSON.stringify(str(key)), _whole_value(object[key], depth + 1)]
			)
		return "{%s}" % ", ".join(texts)
	return JSON.stringify(shown)
