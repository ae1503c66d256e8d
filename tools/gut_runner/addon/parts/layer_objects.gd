# SPDX-License-Identifier: MIT
extends "layer_containers.gd"
## Asserts on objects: class, methods, properties, lifetime.


## The object is an instance of a class or of one derived from it. (GUT 9.6 itself trips over
## abstract classes of the engine such as CanvasItem: name one that can be instantiated.)
func assert_is(object: Variant, a_class: Variant, text: Variant = "") -> void:
	if object is not Object or not is_instance_valid(object):
		_check(false, "{0} is not an object", [object], text)
	elif not _is_class(a_class):
		_check(false, "{0} is not a class", [a_class], text)
	else:
		var holds: bool = is_instance_of(object, a_class)
		_check(holds, "{0} expected to extend {1}", [object, a_class], text)


func assert_has_method(obj: Variant, method: Variant, text: Variant = "") -> void:
	if _is_object(obj, text):
		_check(obj.has_method(method), "{0} expected to have the method {1}", [obj, method], text)


## get_PROPERTY() gives the default; after set_PROPERTY(set_to) it gives set_to.
func assert_accessors(obj: Variant, property: Variant, default: Variant, set_to: Variant) -> void:
	if not _is_object(obj, ""):
		return
	var getter: String = "get_%s" % property
	var setter: String = "set_%s" % property
	assert_has_method(obj, getter)
	assert_has_method(obj, setter)
	if obj.has_method(getter) and obj.has_method(setter):
		assert_eq(obj.call(getter), default, "default of %s" % property)
		obj.call(setter, set_to)
		assert_eq(obj.call(getter), set_to, "%s after setting it" % property)


## The inspector shows a property of this name and TYPE_.
func assert_exports(obj: Variant, property_name: Variant, type: Variant) -> void:
	if not _is_object(obj, ""):
		return
	var found: bool = false
	for info: Dictionary in obj.get_property_list():
		if info["name"] == property_name and info["usage"] & PROPERTY_USAGE_EDITOR:
			found = info["type"] == type
	var message: String = "{0} expected to export {1} as " + type_string(type)
	_check(found, message, [obj, property_name], "")


## A property of a script with `set` and `get` of its own has the default and takes the new value.
func assert_property(
	obj: Variant, property_name: Variant, default_value: Variant, new_value: Variant
) -> void:
	if not _is_object(obj, ""):
		return
	assert_has_method(obj, "@%s_setter" % property_name)
	assert_has_method(obj, "@%s_getter" % property_name)
	assert_eq(obj.get(property_name), default_value, "default of %s" % property_name)
	obj.set(property_name, new_value)
	assert_eq(obj.get(property_name), new_value, "%s after setting it" % property_name)


## The object was freed. An object that only waits for its queue_free() was not.
func assert_freed(obj: Variant, title: Variant = "something") -> void:
	_check(not is_instance_valid(obj), "{0} expected to be freed", [obj], title)


func assert_not_freed(obj: Variant, title: Variant = "something") -> void:
	_check(is_instance_valid(obj), "{0} expected not to be freed", [obj], title)


## The test has so far made no node that is outside the tree.
func assert_no_new_orphans(text: Variant = "") -> void:
	var orphans: PackedStringArray = []
	for id: int in Node.get_orphan_node_ids():
		if id not in _orphans_before:
			orphans.append(str(instance_from_id(id)))
	_check(orphans.is_empty(), "expected no orphans, found {0}", [", ".join(orphans)], text)


func _is_object(obj: Variant, text: Variant) -> bool:
	if obj is Object and is_instance_valid(obj):
		return true
	_check(false, "{0} is not an object", [obj], text)
	return false


func _is_class(thing: Variant) -> bool:
	if thing is not Object or not is_instance_valid(thing):
		return false
	# Typed, since a call on a Variant would look for a static method of the class.
	var object: Object = thing
	return thing is Script or object.get_class() == "GDScriptNativeClass"
