# SPDX-License-Identifier: MIT
## What the engine knows of the classes: properties, defaults, signals, default arguments.
extends "res://cases/provider_case.gd"

var _calls := ProbeCalls.new()
var _heard: Array = []


func test_property_list() -> void:
	var names: Array[String] = []
	var gain := {}
	for property: Dictionary in ProbeResource.new().get_property_list():
		names.append(property["name"])
		if property["name"] == "gain":
			gain = property
	var start := names.find("Measures")
	check(start >= 0, "the group is listed")
	equal(names.slice(start, start + 5), ["Measures", "gain", "More", "mode", "data"], "order")
	equal(gain["type"], TYPE_FLOAT, "type")
	equal(gain["hint"], PROPERTY_HINT_RANGE, "hint")
	equal(gain["hint_string"], "0,10,0.1,suffix:dB", "hint string")
	check(names.has("extra"), "_get_property_list() adds one")


func test_properties_work() -> void:
	var resource := ProbeResource.new()
	resource.gain = 3.5
	equal(resource.gain, 3.5, "number")
	resource.set("mode", ProbeResource.MODE_STATIC)
	equal(resource.get("mode"), 0, "enumeration")
	resource.set("extra", 8)
	equal(resource.get("extra"), 8, "_set() and _get()")
	equal(resource.get("nonsense"), null, "an unknown property is nil")


func test_defaults_for_the_inspector() -> void:
	equal(ClassDB.class_get_property_default_value("ProbeResource", "gain"), 2.5, "gain")
	equal(ClassDB.class_get_property_default_value("ProbeResource", "mode"), 1, "mode")
	var resource := ProbeResource.new()
	equal(resource.property_can_revert("gain"), false, "nothing of its own to revert to")


func test_validate_property() -> void:
	var resource := ProbeResource.new()
	equal(_usage_of(resource, "mode"), PROPERTY_USAGE_DEFAULT, "editable")
	resource.gain = 0.0
	equal(
		_usage_of(resource, "mode"), PROPERTY_USAGE_NO_EDITOR | PROPERTY_USAGE_READ_ONLY, "hidden"
	)


func test_default_arguments() -> void:
	equal(_calls.with_defaults(1).slice(0, 3), [1, 1.5, "three"], "all defaults")
	equal(_calls.with_defaults(1)[3], null, "a reference to nothing")
	equal(_calls.with_defaults(1, 2.0).slice(0, 3), [1, 2.0, "three"], "one given")
	var resource := ProbeResource.new()
	equal(_calls.with_defaults(1, 2.0, "x", resource), [1, 2.0, "x", resource], "all given")
	var dynamic: Array = _calls.call("with_defaults", 5)
	equal(dynamic.slice(0, 3), [5, 1.5, "three"], "dynamic call")
	equal(ProbeCalls.add(1), 11, "static method with a default")
	equal(ProbeCalls.add(1, 2), 3, "static method")
	for method: Dictionary in ClassDB.class_get_method_list("ProbeCalls", true):
		if method["name"] == "with_defaults":
			var defaults: Array = method["default_args"]
			equal(defaults.slice(0, 2), [1.5, "three"], "the engine knows them")
			equal(defaults[2], null, "a reference to nothing")


func test_signal_with_arguments() -> void:
	var resource := ProbeResource.new()
	resource.gain_changed.connect(_on_gain_changed)
	resource.gain = 4.0
	resource.gain = 4.0
	equal(_heard, [4.0, resource], "emitted once, with its arguments")
	equal(resource.get_reference_count(), 2, "the reference passed along has been dropped again")
	_heard.clear()
	resource.gain_changed.disconnect(_on_gain_changed)
	resource.gain = 5.0
	equal(_heard, [], "disconnected")
	for signal_info: Dictionary in ClassDB.class_get_signal_list("ProbeResource", true):
		if signal_info["name"] == "gain_changed":
			var source: Dictionary = signal_info["args"][1]
			equal(source["class_name"], &"ProbeResource", "class of the second argument")


func test_cpp_connects_its_own_methods() -> void:
	equal(
		_calls.connect_twice(), 7, "3 + 4, nothing after disconnecting; equal callables are equal"
	)


func test_callables() -> void:
	equal(_calls.call_with(func(x: int) -> int: return x + 1, 4), 5, "C++ calls a lambda")
	equal(_calls.call_with(_calls.get_doubler(), 4), 8, "C++ calls its own")
	var doubler := _calls.get_doubler()
	equal(doubler.get_object(), _calls, "object")
	check(doubler == _calls.get_doubler(), "equal")
	var other := ProbeCalls.new()
	check(doubler != other.get_doubler(), "another object's differs")
	other.keep(null)
	doubler = other.get_doubler()
	other = null
	if strict:
		equal(doubler.is_valid(), false, "it does not keep its object alive")


func test_inheritance_is_known() -> void:
	equal(ClassDB.get_parent_class("ProbeChildNode"), &"ProbeNode", "parent")
	check(ClassDB.is_parent_class("ProbeChildNode", "Node3D"), "ancestor")


func _on_gain_changed(gain: float, source: ProbeResource) -> void:
	_heard.append_array([gain, source])


func _usage_of(object: Object, property_name: String) -> int:
	for property: Dictionary in object.get_property_list():
		if property["name"] == property_name:
			return property["usage"]
	return -1
