# SPDX-License-Identifier: MIT
class_name JsonSchemaCheck
extends RefCounted
## Walks through data and a schema side by side and collects what does not fit. The schema must
## have been vetted by JsonSchema.

var _definitions: Dictionary
var _title: String


func _init(definitions: Dictionary, title: String) -> void:
	_definitions = definitions
	_title = title.to_lower()


## What a schema forbids in a value at a place; the first is the one to report. `known` are the
## properties that the schemas around know at this place, for their descriptions.
func faults(
	value: Variant, schema: Dictionary, place: String, known: Dictionary = {}
) -> Array[JsonFault]:
	var found: Array[JsonFault] = []
	known = known.merged(schema.get("properties", {}), true)
	if schema.has("$ref"):
		found.append_array(faults(value, JsonKinds.referred(schema, _definitions), place, known))
	if not _fits(value, schema):
		found.append(wrong_value(value, JsonWords.expected(schema, _definitions), place))
		return found
	if value is Array:
		found.append_array(_list_faults(value, schema, place))
	if value is Dictionary:
		found.append_array(_object_faults(value, schema, place, known))
	found.append_array(_combined_faults(value, schema, place, known))
	return found


## The sentence that says what a value must be.
func wrong_value(value: Variant, expected: String, place: String) -> JsonFault:
	var text := "%s must be %s, not %s." % [subject(place), expected, JsonWords.value(value)]
	return JsonFault.new(JsonFault.Kind.VALUE, place, text)


## How a sentence calls a place.
func subject(place: String) -> String:
	return "A " + _title if place.is_empty() else place


func _fits(value: Variant, schema: Dictionary) -> bool:
	var has_type := func(type: String) -> bool: return JsonKinds.is_type(value, type)
	if schema.has("type") and not Array(JsonKinds.types(schema)).any(has_type):
		return false
	var allowed := JsonKinds.named_values(schema)
	if not allowed.is_empty() and not JsonKinds.has_same(allowed, value):
		return false
	if JsonKinds.is_number(value):
		return _in_range(value, schema)
	return _is_spelt(value, schema) if JsonKinds.is_type(value, "string") else true


func _in_range(number: float, schema: Dictionary) -> bool:
	return not (
		(schema.has("minimum") and number < float(schema["minimum"]))
		or (schema.has("maximum") and number > float(schema["maximum"]))
		or (schema.has("exclusiveMinimum") and number <= float(schema["exclusiveMinimum"]))
		or (schema.has("exclusiveMaximum") and number >= float(schema["exclusiveMaximum"]))
	)


func _is_spelt(text: String, schema: Dictionary) -> bool:
	if text.length() < int(float(schema.get("minLength", 0))):
		return false
	if not schema.has("pattern"):
		return true
	var pattern: String = schema["pattern"]
	return RegEx.create_from_string(pattern).search(text) != null


func _list_faults(list: Array, schema: Dictionary, place: String) -> Array[JsonFault]:
	var found: Array[JsonFault] = []
	var most: float = schema.get("maxItems", INF)
	var expected := JsonWords.expected(schema, _definitions)
	if list.size() < float(schema.get("minItems", 0)) or list.size() > most:
		found.append(wrong_value(list, expected, place))
	elif schema.get("uniqueItems", false):
		for i in JsonKinds.repeated(list):
			found.append(_wrong_item(list[i], "%s[%d]" % [place, i], expected, place))
	var first: Array = schema.get("prefixItems", [])
	for i in list.size():
		var item_place := "%s[%d]" % [place, i]
		if i < first.size():
			var own: Dictionary = first[i]
			found.append_array(faults(list[i], own, item_place))
		elif schema.has("items"):
			var every: Dictionary = schema["items"]
			for fault in faults(list[i], every, item_place):
				# Of a list of numbers, say that it is to be one: the place alone tells less.
				if fault.kind == JsonFault.Kind.VALUE and fault.place == item_place:
					fault = _wrong_item(list[i], item_place, expected, place)
				found.append(fault)
	return found


func _wrong_item(item: Variant, item_place: String, expected: String, place: String) -> JsonFault:
	var text := (
		"%s must be %s; %s is %s." % [subject(place), expected, item_place, JsonWords.value(item)]
	)
	return JsonFault.new(JsonFault.Kind.VALUE, place, text)


func _object_faults(
	object: Dictionary, schema: Dictionary, place: String, known: Dictionary
) -> Array[JsonFault]:
	var found: Array[JsonFault] = []
	var properties: Dictionary = schema.get("properties", {})
	if schema.has("additionalProperties"):
		for key: Variant in object:
			if not properties.has(key):
				var text := (
					"%s is no key of a %s; known: %s."
					% [_join(place, str(key)), _title, JsonWords.names(properties.keys())]
				)
				found.append(JsonFault.new(JsonFault.Kind.UNKNOWN, place, text))
	for key: String in schema.get("required", []):
		if not object.has(key):
			found.append(_missing(key, place, known))
	for key: String in properties:
		if object.has(key):
			var own: Dictionary = properties[key]
			found.append_array(faults(object[key], own, _join(place, key)))
	return found


func _missing(key: String, place: String, known: Dictionary) -> JsonFault:
	var text := "%s is missing" % _join(place, key)
	var own: Dictionary = known.get(key, {})
	var allowed := JsonKinds.named_values(own)
	if not allowed.is_empty():
		text += "; it must be one of: " + JsonWords.names(allowed)
	elif own.has("description"):
		text += ": %s" % own["description"]
	return JsonFault.new(JsonFault.Kind.MISSING, place, text.trim_suffix(".") + ".")


func _combined_faults(
	value: Variant, schema: Dictionary, place: String, known: Dictionary
) -> Array[JsonFault]:
	var found: Array[JsonFault] = []
	for part: Dictionary in schema.get("allOf", []):
		found.append_array(faults(value, part, place, known))
	for keyword: String in ["anyOf", "oneOf"]:
		if schema.has(keyword):
			var choice := JsonSchemaChoice.new(self, _definitions, schema[keyword])
			found.append_array(choice.faults(value, place, known, keyword == "oneOf"))
	if schema.has("not"):
		var forbidden: Dictionary = schema["not"]
		if faults(value, forbidden, place, known).is_empty():
			found.append(_forbidden(forbidden, place))
	if schema.has("if"):
		var condition: Dictionary = schema["if"]
		var holds := faults(value, condition, place, known).is_empty()
		found.append_array(faults(value, schema.get("then" if holds else "else", {}), place, known))
	return found


## A "not" may say why in its description.
func _forbidden(schema: Dictionary, place: String) -> JsonFault:
	var expected := JsonWords.expected(schema, _definitions)
	var text := "%s must not be %s." % [subject(place), expected]
	if schema.has("description"):
		var why: String = schema["description"]
		text = why if place.is_empty() else "%s: %s" % [place, why]
	return JsonFault.new(JsonFault.Kind.RULE, place, text)


func _join(place: String, key: String) -> String:
	return key if place.is_empty() else "%s.%s" % [place, key]
