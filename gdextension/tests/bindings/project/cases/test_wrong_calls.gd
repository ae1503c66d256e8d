# SPDX-License-Identifier: MIT
## Calls that do not fit give a script error, end the calling function and harm nothing.
## Upstream passes objects of the wrong class on; our provider refuses them (_refused_if_strict).
extends "res://cases/provider_case.gd"

const REACHED := "the line after the bad call"

var _calls: Variant = ProbeCalls.new()


func test_too_few_arguments() -> void:
	_refused(
		func() -> String:
			_calls.describe("a")
			return REACHED,
		"3",
		"method"
	)
	_refused(
		func() -> String:
			_calls.with_defaults()
			return REACHED,
		"argument",
		"with defaults"
	)


func test_too_many_arguments() -> void:
	_refused(
		func() -> String:
			_calls.pass_int32(1, 2)
			return REACHED,
		"1",
		"method"
	)
	_refused(
		func() -> String:
			_calls.convert_all(1)
			return REACHED,
		"0",
		"no arguments"
	)


func test_wrong_types() -> void:
	_refused(
		func() -> String:
			_calls.pass_int32("text")
			return REACHED,
		"int",
		"String for int"
	)
	_refused(
		func() -> String:
			_calls.pass_vector3(1.0)
			return REACHED,
		"Vector3",
		"float for Vector3"
	)
	_refused(
		func() -> String:
			_calls.pass_dictionary([])
			return REACHED,
		"Dictionary",
		"Array for Dictionary"
	)
	_refused(
		func() -> String:
			_calls.describe("a", 1, [])
			return REACHED,
		"argument 3",
		"third"
	)


func test_wrong_objects() -> void:
	_refused_if_strict(
		func() -> String:
			_calls.pass_resource(Resource.new())
			return REACHED,
		"not a subclass",
		"Resource"
	)
	_refused_if_strict(
		func() -> String:
			_calls.pass_node(ProbeResource.new())
			return REACHED,
		"",
		"not a node"
	)
	_refused(
		func() -> String:
			_calls.pass_resource(42)
			return REACHED,
		"",
		"int for an object"
	)


func test_null_is_an_object() -> void:
	equal(_calls.pass_resource(null), null, "null reference")
	equal(_calls.pass_node(null), null, "null node")
	equal(_calls.class_of(null), "null", "null object")


func test_unknown_names() -> void:
	_refused(
		func() -> String:
			_calls.no_such_method()
			return REACHED,
		"no_such_method",
		"method"
	)
	_refused(
		func() -> String:
			_calls.no_such_property = 1
			return REACHED,
		"no_such_property",
		"set"
	)


func test_abstract_class_cannot_be_made() -> void:
	equal(ClassDB.can_instantiate("ProbeShape"), false, "abstract class")
	equal(ClassDB.can_instantiate("ProbeCircle"), true, "its child")
	var circle: Variant = ProbeCircle.new()
	equal(circle.get_area(), 3.0, "inherited method calls the child's override")


func test_freed_object_is_refused() -> void:
	var nodes: Array[Node] = [Node.new()]
	nodes[0].free()
	_refused_if_strict(
		func() -> String:
			_calls.pass_node(nodes[0])
			return REACHED,
		"freed",
		"freed node"
	)
	equal(_calls.is_alive(1), false, "no object has this id")


func test_bad_property_value() -> void:
	var resource: Variant = ProbeResource.new()
	_refused(
		func() -> String:
			resource.gain = "loud"
			return REACHED,
		"gain",
		"text for a number"
	)
	if strict:
		equal(resource.gain, 2.5, "the value is unchanged")


func test_wrong_callable_arguments() -> void:
	var doubler: Callable = _calls.get_doubler()
	equal(doubler.call(21), 42, "right")
	equal(doubler.get_argument_count(), 1, "argument count")
	_refused(
		func() -> String:
			doubler.call()
			return REACHED,
		"",
		"too few"
	)
	_refused(
		func() -> String:
			doubler.call(1, 2)
			return REACHED,
		"",
		"too many"
	)
	_refused(
		func() -> String:
			doubler.call([])
			return REACHED,
		"",
		"wrong type"
	)


func test_error_macros() -> void:
	fails(func() -> void: _calls.fail_softly(3), "below three", "index")
	fails(func() -> void: _calls.fail_softly(2), "Two is refused, not 2.", "condition")
	fails(func() -> void: _calls.fail_softly(0), "Nothing failed.", "warning")


# The call logs an error and ends the function before the next line.
func _refused(bad_call: Callable, text: String, what: String) -> void:
	var returned: Variant = fails(bad_call, text, what)
	check(returned != REACHED, what + ": the script went on")


func _refused_if_strict(bad_call: Callable, text: String, what: String) -> void:
	if strict:
		_refused(bad_call, text, what)
