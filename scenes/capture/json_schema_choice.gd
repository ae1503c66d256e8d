# SPDX-License-Identifier: MIT
class_name JsonSchemaChoice
extends RefCounted
## The branches of an anyOf or oneOf: which of them a value was meant for, and what is wrong there.
##
## Branches are told apart by the type of the value, then by a property that names the branch with a
## "const" or an "enum", such as the "motion" of an observer.

enum Fit { OTHER_TYPE, OTHER_NAME, MEANT }

var _checker: JsonSchemaCheck
var _definitions: Dictionary
var _branches: Array


func _init(checker: JsonSchemaCheck, definitions: Dictionary, branches: Array) -> void:
	_checker = checker
	_definitions = definitions
	_branches = branches


## What is wrong with a value; empty when one branch takes it. Only one may when `single` is set.
func faults(value: Variant, place: String, known: Dictionary, single: bool) -> Array[JsonFault]:
	var passing := 0
	var best: Array[JsonFault] = []
	var best_fit := Fit.OTHER_TYPE
	for branch: Dictionary in _branches:
		var wrong := _checker.faults(value, branch, place, known)
		passing += 1 if wrong.is_empty() else 0
		var fit := _fit(value, branch)
		if best.is_empty() or fit > best_fit or (fit == best_fit and wrong.size() < best.size()):
			best_fit = fit
			best = wrong
	if passing == 1 or (passing > 1 and not single):
		return []
	var keys := _keys_to_choose()
	if not keys.is_empty():
		var many := "exactly" if single else "at least"
		return _rule(place, "give %s one of: %s" % [many, JsonWords.names(keys)])
	if passing > 1:
		return _rule(place, "this fits several of the forms allowed, not one")
	if best_fit == Fit.OTHER_NAME:
		return _checker.faults(value, _naming(), place, known)
	if best_fit == Fit.MEANT and (best[0].kind != JsonFault.Kind.VALUE or best[0].place != place):
		return best
	var allowed := JsonWords.alternatives(_branches, _definitions)
	return [_checker.wrong_value(value, allowed, place)]


func _fit(value: Variant, branch: Dictionary) -> Fit:
	branch = JsonKinds.target(branch, _definitions)
	var same_type := func(type: String) -> bool: return JsonKinds.is_type(value, type)
	var same_kind := func(value_named: Variant) -> bool:
		return JsonKinds.same_kind(value_named, value)
	var named := JsonKinds.named_values(branch)
	if not Array(JsonKinds.types(branch)).any(same_type):
		return Fit.OTHER_TYPE
	if not named.is_empty() and not named.any(same_kind):
		return Fit.OTHER_TYPE
	if value is Dictionary:
		var object: Dictionary = value
		var names := _names(branch)
		for key: String in names:
			var allowed: Array = names[key]
			if not object.has(key) or not JsonKinds.has_same(allowed, object[key]):
				return Fit.OTHER_NAME
	return Fit.MEANT


## The required properties that name a branch, with the values that mean this one.
func _names(branch: Dictionary) -> Dictionary[String, Array]:
	var found: Dictionary[String, Array] = {}
	var properties: Dictionary = branch.get("properties", {})
	for key: String in branch.get("required", []):
		var allowed := JsonKinds.named_values(properties.get(key, {}))
		if not allowed.is_empty():
			found[key] = allowed
	return found


## A schema that asks for nothing but a name that means one of the branches.
func _naming() -> Dictionary:
	var properties: Dictionary = {}
	for branch: Dictionary in _branches:
		var names := _names(JsonKinds.target(branch, _definitions))
		for key: String in names:
			var property: Dictionary = properties.get_or_add(key, {"enum": []})
			var allowed: Array = property["enum"]
			allowed.append_array(names[key])
	return {"properties": properties, "required": properties.keys()}


## The keys to choose from when every branch asks for one key and for nothing else; else empty.
func _keys_to_choose() -> Array:
	var keys: Array = []
	for branch: Dictionary in _branches:
		var required: Array = branch.get("required", [])
		if branch.size() != 1 or required.size() != 1:
			return []
		keys.append(required[0])
	return keys


func _rule(place: String, reason: String) -> Array[JsonFault]:
	var text := "%s: %s." % [_checker.subject(place), reason]
	return [JsonFault.new(JsonFault.Kind.RULE, place, text)]
