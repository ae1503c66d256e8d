# SPDX-License-Identifier: MIT
extends GutTest
## The JSON Schema validator: every keyword both ways, the words of its messages, schemas refused.

## What a value is checked against, values that pass, values that do not.
const KEYWORDS: Array = [
	[{"type": "null"}, [null], [0, "", false]],
	[{"type": "boolean"}, [true, false], [0, 1, "true", null]],
	[{"type": "integer"}, [3, 3.0, -1, 1e300], [3.5, "3", true, NAN, INF]],
	[{"type": "number"}, [3, 3.5, -1e-300], ["3", true, null, NAN, -INF]],
	[{"type": "string"}, ["", "a"], [1, null, ["a"]]],
	[{"type": "array"}, [[], [1, "a"]], [{}, "a", null]],
	[{"type": "object"}, [{}, {"a": 1}], [[], "a", null]],
	[{"type": ["string", "null"]}, ["a", null], [1, [], false]],
	[{"enum": ["a", 1, null]}, ["a", 1, 1.0, null], ["b", 2, true, false, "1"]],
	[{"const": [1, {"a": true}]}, [[1, {"a": true}], [1.0, {"a": true}]], [[1], [1, {"a": 1}]]],
	[{"minimum": 2}, [2, 3, "1", null], [1.99, -5]],
	[{"maximum": 2}, [2, 1], [2.01]],
	[{"exclusiveMinimum": 2}, [2.01], [2, 1]],
	[{"exclusiveMaximum": 2}, [1.99], [2, 3]],
	[{"minLength": 2}, ["ab", "äö", 1], ["a", ""]],
	[{"pattern": "^a.*z$"}, ["az", "abcz", 1], ["za", "azb"]],
	[{"pattern": "b"}, ["abc"], ["ac"]],
	[{"items": {"type": "number"}}, [[], [1, 2], "a"], [["a"], [1, null]]],
	[{"prefixItems": [{"const": 1}, {"const": 2}]}, [[], [1], [1, 2, 9]], [[2], [1, 1]]],
	[{"prefixItems": [{"const": 1}], "items": {"const": 0}}, [[1, 0, 0]], [[0], [1, 0, 1]]],
	[{"minItems": 2}, [[1, 2], [1, 2, 3]], [[], [1]]],
	[{"maxItems": 2}, [[], [1, 2]], [[1, 2, 3]]],
	[{"uniqueItems": true}, [[], [1, true, "1"], [[1], [2]]], [[1, 1.0], [[1], [1]]]],
	[{"properties": {"a": {"type": "null"}}}, [{}, {"a": null}, {"b": 1}, []], [{"a": 1}]],
	[{"required": ["a", "b"]}, [{"a": 1, "b": null}, 7], [{}, {"a": 1}]],
	[
		{"properties": {"a": {}}, "additionalProperties": false},
		[{}, {"a": 1}, []],
		[{"b": 1}, {"a": 1, "b": 1}]
	],
	[{"allOf": [{"minimum": 1}, {"maximum": 3}]}, [1, 2, 3], [0, 4]],
	[{"anyOf": [{"maximum": 1}, {"minimum": 0}]}, [-1, 0.5, 2], [NAN]],
	[{"anyOf": [{"const": 1}, {"const": 2}]}, [1, 2], [3, "1"]],
	[{"oneOf": [{"maximum": 1}, {"minimum": 0}]}, [-1, 2], [0, 0.5, 1, "both"]],
	[{"not": {"const": 1}}, [2, "1"], [1, 1.0]],
	[{"if": {"minimum": 0}, "then": {"maximum": 9}, "else": {"const": -1}}, [0, 9, -1], [10, -2]],
	[{"if": {"required": ["a"]}, "else": {"required": ["b"]}}, [{"a": 1}, {"b": 1}], [{}]],
	[{"$ref": "#/$defs/small", "$defs": {"small": {"maximum": 1}}}, [1], [2]],
	[{"$ref": "#/$defs/small", "minimum": 0, "$defs": {"small": {"maximum": 1}}}, [0, 1], [-1, 2]],
	[
		{
			"$ref": "#/$defs/tree",
			"$defs": {"tree": {"type": "array", "items": {"$ref": "#/$defs/tree"}}}
		},
		[[], [[], [[]]]],
		[[1], [[[0]]]]
	],
	[
		{
			"$schema": "a",
			"$id": "b",
			"$comment": "c",
			"title": "d",
			"description": "e",
			"default": 1,
			"examples": [1]
		},
		[1, "a", null, []],
		[NAN, [INF], {"a": [NAN]}]
	],
]

## A schema that tells its branches apart by a property.
const SHAPES: Dictionary = {
	"oneOf":
	[
		{"enum": ["point"]},
		{
			"type": "object",
			"additionalProperties": false,
			"required": ["kind", "radius"],
			"properties":
			{
				"kind": {"const": "circle"},
				"radius": {"type": "number", "exclusiveMinimum": 0},
			},
		},
		{
			"type": "object",
			"additionalProperties": false,
			"required": ["kind"],
			"properties":
			{
				"kind": {"enum": ["square", "rhombus"]},
				"side": {"type": "number"},
				"angle": {"type": "number"},
			},
		},
	]
}


func test_every_keyword_lets_through_and_refuses(row: Array = use_parameters(KEYWORDS)) -> void:
	var schema := JsonSchema.from_data(row[0])
	assert_eq(schema.error, "")
	for value: Variant in row[1]:
		assert_eq(schema.check(value), "", "%s lets %s through" % [row[0], value])
	for value: Variant in row[2]:
		assert_ne(schema.check(value), "", "%s refuses %s" % [row[0], value])


func test_every_keyword_is_tested() -> void:
	var text := var_to_str(KEYWORDS)
	for keyword: String in JsonSchema.KEYWORDS:
		assert_string_contains(text, '"%s":' % keyword)


func test_messages(
	# schema, value, the whole message
	p: Array = use_parameters(
		[
			[{"type": "number"}, "a", 'A value must be a number, not "a".'],
			[{"type": "number", "title": "Dose"}, null, "A dose must be a number, not null."],
			[{"properties": {"a": {"type": "array"}}}, {"a": 1}, "a must be a list, not 1."],
			[
				{"properties": {"a": {"properties": {"b": {"minimum": 1, "type": "integer"}}}}},
				{"a": {"b": 0.5}},
				"a.b must be a whole number of at least 1, not 0.5."
			],
			[
				{"type": "number", "exclusiveMinimum": 0, "maximum": 2.5},
				3,
				"A value must be a number greater than 0 and of at most 2.5, not 3."
			],
			[
				{"items": {"properties": {"a": {"const": 1}}}},
				[{}, {"a": 2}],
				"[1].a must be 1, not 2."
			],
			[
				{"type": "array", "items": {"type": "string"}, "minItems": 1, "maxItems": 4},
				["a", 7],
				"A value must be a list of 1 to 4 strings; [1] is 7."
			],
			[
				{"type": "array", "uniqueItems": true},
				[1, 2, 1],
				"A value must be a list of different values; [2] is 1."
			],
			[
				{"properties": {"a": {}, "b": {}}, "additionalProperties": false},
				{"c": 1},
				"c is no key of a value; known: a, b."
			],
			[
				{"properties": {"a": {"description": "how many"}}, "required": ["a"]},
				{},
				"a is missing: how many."
			],
			[
				{"properties": {"a": {"enum": ["x", "y"]}}, "required": ["a"]},
				{},
				"a is missing; it must be one of: x, y."
			],
			[
				{"properties": {"a": {"pattern": "^x", "description": "a word with x"}}},
				{"a": "y"},
				'a must be a word with x, not "y".'
			],
			[{"not": {"const": 1, "description": "not now."}}, 1, "not now."],
			[{"properties": {"a": {"not": {"const": 1}}}}, {"a": 1}, "a must not be 1."],
			[
				{"anyOf": [{"required": ["a"]}, {"required": ["b"]}]},
				{},
				"A value: give at least one of: a, b."
			],
			[
				{"oneOf": [{"required": ["a"]}, {"required": ["b"]}]},
				{"a": 1, "b": 1},
				"A value: give exactly one of: a, b."
			],
			[
				{"type": "object", "properties": {"a": {"type": "number"}}},
				{"a": "a text that goes on and on and never comes to its point"},
				'a must be a number, not "a text that goes on and on and never comes t....'
			],
		]
	)
) -> void:
	assert_eq(JsonSchema.from_data(p[0]).check(p[1]), p[2])


func test_of_several_forms_the_one_meant_is_reported(
	p: Array = use_parameters(
		[
			["line", 'A value must be one of: point; or a JSON object, not "line".'],
			[[], "A value must be one of: point; or a JSON object, not []."],
			[{}, "kind is missing; it must be one of: circle, square, rhombus."],
			[{"kind": "line"}, 'kind must be one of: circle, square, rhombus, not "line".'],
			[{"kind": "circle"}, "radius is missing."],
			[{"kind": "circle", "radius": 0}, "radius must be a number greater than 0, not 0."],
			[{"kind": "circle", "side": 1}, "side is no key of a value; known: kind, radius."],
			[{"kind": "rhombus", "angle": "a"}, 'angle must be a number, not "a".'],
			[{"radius": 1}, "kind is missing; it must be one of: circle, square, rhombus."],
		]
	)
) -> void:
	assert_eq(JsonSchema.from_data(SHAPES).check(p[0]), p[1])
	assert_eq(JsonSchema.from_data(SHAPES).check("point"), "")
	assert_eq(JsonSchema.from_data(SHAPES).check({"kind": "rhombus"}), "")


func test_schemas_that_are_refused(
	# the schema, words of the refusal
	p: Array = use_parameters(
		[
			[[], "A schema is a JSON object"],
			[{"format": "email"}, '#: the keyword "format" is not supported'],
			[{"properties": {"a": {"maxLength": 1}}}, '#/properties/a: the keyword "maxLength"'],
			[
				{"items": {"anyOf": [{}, {"$anchor": "a"}]}},
				'#/items/anyOf/1: the keyword "$anchor"'
			],
			[{"$defs": {"a": {"contains": {}}}}, '#/$defs/a: the keyword "contains"'],
			[{"items": {"$defs": {}}}, "$defs belong at the top"],
			[{"items": true}, "#/items: a schema is a JSON object, not true"],
			[{"type": "float"}, "#/type: must be types"],
			[{"type": []}, "#/type"],
			[{"minimum": "1"}, "#/minimum: must be number"],
			[{"minItems": -1}, "#/minItems: must be count"],
			[{"minLength": 1.5}, "#/minLength"],
			[{"additionalProperties": true}, "#/additionalProperties: must be false"],
			[{"additionalProperties": {}}, "#/additionalProperties"],
			[{"required": "a"}, "#/required: must be names"],
			[{"required": [1]}, "#/required"],
			[{"enum": []}, "#/enum: must be list"],
			[{"oneOf": []}, "#/oneOf: must be a list of schemas"],
			[{"allOf": {}}, "#/allOf"],
			[{"properties": []}, "#/properties"],
			[{"uniqueItems": 1}, "#/uniqueItems"],
			[{"title": 1}, "#/title: must be text"],
			[{"pattern": "("}, "#/pattern: must be a regular expression"],
			[{"$ref": "#/$defs/none"}, "#/$ref"],
			[{"$ref": "other.json"}, "#/$ref"],
			[{"$defs": {"a": {"$ref": "#/$defs/a"}}}, "#/$defs/a: it is defined by itself"],
			[
				{
					"$defs":
					{"a": {"anyOf": [{"$ref": "#/$defs/b"}]}, "b": {"not": {"$ref": "#/$defs/a"}}}
				},
				"it is defined by itself"
			],
		]
	)
) -> void:
	var schema := JsonSchema.from_data(p[0])
	assert_string_contains(schema.error, p[1])
	assert_eq(schema.check({}), schema.error, "nothing passes a schema that was refused")


func test_a_schema_that_is_not_there() -> void:
	var schema := JsonSchema.from_file("res://no/such.schema.json")
	assert_string_contains(schema.error, "no/such.schema.json")
