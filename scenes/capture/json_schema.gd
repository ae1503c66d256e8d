# SPDX-License-Identifier: MIT
class_name JsonSchema
extends RefCounted
## Checks data against a schema in a subset of JSON Schema 2020-12.
##
## Known are type, enum, const; minimum, maximum, exclusiveMinimum, exclusiveMaximum; minLength,
## pattern; items, prefixItems, minItems, maxItems, uniqueItems; properties, required,
## additionalProperties (false only); allOf, anyOf, oneOf, not, if, then, else; $ref to
## "#/$defs/NAME". Titles, descriptions, defaults and examples do not take part in the check, but
## messages quote titles and descriptions. A schema with any other keyword is refused: what it asks
## for would go unchecked.

## What the value of each keyword must be.
const KEYWORDS: Dictionary[String, String] = {
	"$schema": "text",
	"$id": "text",
	"$comment": "text",
	"title": "text",
	"description": "text",
	"default": "anything",
	"examples": "list",
	"$defs": "named schemas",
	"$ref": "reference",
	"type": "types",
	"enum": "list",
	"const": "anything",
	"minimum": "number",
	"maximum": "number",
	"exclusiveMinimum": "number",
	"exclusiveMaximum": "number",
	"minLength": "count",
	"pattern": "pattern",
	"items": "schema",
	"prefixItems": "schemas",
	"minItems": "count",
	"maxItems": "count",
	"uniqueItems": "flag",
	"properties": "named schemas",
	"required": "names",
	"additionalProperties": "false",
	"allOf": "schemas",
	"anyOf": "schemas",
	"oneOf": "schemas",
	"not": "schema",
	"if": "schema",
	"then": "schema",
	"else": "schema",
}

## Data with more lists and objects in each other are refused: to walk through them takes a call for
## each.
const DEEPEST: int = 64

## Why the schema was refused; empty when it is fine.
var error: String = ""

var _schema: Dictionary = {}
var _definitions: Dictionary = {}


## Takes a schema from a JSON file of the project; as a resource, which exported projects hold too.
static func from_file(path: String) -> JsonSchema:
	var file: JSON = load(path) if ResourceLoader.exists(path) else null
	if file == null:
		var refused := JsonSchema.new()
		refused.error = "There is no schema %s." % path
		return refused
	return from_data(file.data)


## Takes a schema from parsed JSON.
static func from_data(data: Variant) -> JsonSchema:
	var schema := JsonSchema.new()
	if data is not Dictionary:
		schema.error = "A schema is a JSON object, not %s." % JsonWords.value(data)
		return schema
	schema._schema = data
	var definitions: Variant = schema._schema.get("$defs", {})
	schema._definitions = definitions if definitions is Dictionary else {}
	schema._vet(schema._schema, "#")
	for name: String in schema._definitions:
		if schema.error.is_empty():
			schema._refuse_circle(schema._definitions[name], [name])
	return schema


## What is wrong with some data, in a sentence that names the place; empty when nothing is.
func check(data: Variant) -> String:
	if not error.is_empty():
		return error
	var title: String = _schema.get("title", "value")
	if JsonKinds.is_deeper(data, DEEPEST):
		return "A %s has no lists and objects %d deep in each other." % [title, DEEPEST]
	var checker := JsonSchemaCheck.new(_definitions, title)
	var faults := checker.faults(data, _schema, "")
	if not faults.is_empty():
		return faults[0].text
	if not JsonKinds.is_json(data):
		return "A %s must not hold what JSON does not know: %s." % [title, JsonWords.value(data)]
	return ""


func _vet(value: Variant, place: String) -> void:
	if value is not Dictionary:
		_refuse(place, "a schema is a JSON object, not %s" % JsonWords.value(value))
		return
	var schema: Dictionary = value
	for keyword: String in schema:
		if not KEYWORDS.has(keyword):
			_refuse(place, 'the keyword "%s" is not supported' % keyword)
		elif keyword == "$defs" and place != "#":
			_refuse(place, "$defs belong at the top")
		else:
			_vet_value(KEYWORDS[keyword], schema[keyword], "%s/%s" % [place, keyword])


func _vet_value(wanted: String, value: Variant, place: String) -> void:
	match wanted:
		"schema":
			_vet(value, place)
		"schemas":
			var branches: Array = value if value is Array else []
			_expect(not branches.is_empty(), place, "a list of schemas", value)
			for i in branches.size():
				_vet(branches[i], "%s/%d" % [place, i])
		"named schemas":
			_expect(value is Dictionary, place, "a JSON object of schemas", value)
			var named: Dictionary = value if value is Dictionary else {}
			for name: String in named:
				_vet(named[name], "%s/%s" % [place, name])
		"reference":
			var path: String = value if value is String else ""
			var name := path.trim_prefix(JsonKinds.DEFINITIONS)
			var known := path.begins_with(JsonKinds.DEFINITIONS) and _definitions.has(name)
			_expect(known, place, '"#/$defs/" and a name that is defined', value)
		"pattern":
			var pattern := (
				RegEx.create_from_string(value, false) if value is String else RegEx.new()
			)
			_expect(pattern.is_valid(), place, "a regular expression", value)
		_:
			_expect(_is_plain(wanted, value), place, wanted, value)


func _is_plain(wanted: String, value: Variant) -> bool:
	var items: Array = value if value is Array else [value]
	var is_text := func(item: Variant) -> bool: return item is String
	var is_type_name := func(item: Variant) -> bool: return item is String and item in JsonKinds.ALL
	var conditions: Dictionary[String, bool] = {
		"anything": true,
		"text": value is String,
		"number": JsonKinds.is_number(value),
		"count": JsonKinds.is_type(value, "integer") and float(value) >= 0.0,
		"flag": value is bool,
		"false": value is bool and not value,
		"list": value is Array and not items.is_empty(),
		"names": value is Array and items.all(is_text),
		"types": not items.is_empty() and items.all(is_type_name),
	}
	return conditions[wanted]


## Definitions that come back to themselves without going a step down in the data never end.
func _refuse_circle(schema: Dictionary, names: PackedStringArray) -> void:
	if schema.has("$ref"):
		var pointer: String = schema["$ref"]
		var name := pointer.trim_prefix(JsonKinds.DEFINITIONS)
		if names.has(name):
			_refuse("#/$defs/" + name, "it is defined by itself")
			return
		_refuse_circle(_definitions[name], names + PackedStringArray([name]))
	for keyword: String in ["allOf", "anyOf", "oneOf"]:
		for branch: Dictionary in schema.get(keyword, []):
			_refuse_circle(branch, names)
	for keyword: String in ["not", "if", "then", "else"]:
		if schema.has(keyword):
			_refuse_circle(schema[keyword], names)


func _expect(fine: bool, place: String, wanted: String, value: Variant) -> void:
	if not fine:
		_refuse(place, "must be %s, not %s" % [wanted, JsonWords.value(value)])


func _refuse(place: String, reason: String) -> void:
	if error.is_empty():
		error = "Schema, %s: %s." % [place, reason]
