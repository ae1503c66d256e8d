# SPDX-License-Identifier: MIT
extends "layer_core.gd"
## Helpers of tests: freeing, simulating frames, versions.

## Instance ids.
var _to_free: Array[int] = []
var _to_queue_free: Array[int] = []
var _orphans_before: Array[int] = []


## Whether the engine is older than "major.minor.patch"; the test then passes and should return.
func skip_if_godot_version_lt(expected: Variant) -> Variant:
	var info: Dictionary = Engine.get_version_info()
	var have: Array[int] = [info["major"], info["minor"], info["patch"]]
	var want: PackedStringArray = str(expected).split(".")
	for i: int in mini(want.size(), 3):
		if have[i] != want[i].to_int():
			if have[i] < want[i].to_int():
				pass_test("skipped: needs Godot %s" % expected)
				return true
			return false
	return false


## Frees the object after the test. Returns it, like the three below.
func autofree(thing: Variant) -> Variant:
	if thing is Object and thing is not RefCounted:
		_to_free.append(thing.get_instance_id())
	return thing


## Calls queue_free() after the test.
func autoqfree(thing: Variant) -> Variant:
	if thing is Node:
		_to_queue_free.append(thing.get_instance_id())
	return thing


## Adds a child to the test and frees it after the test.
func add_child_autofree(node: Variant, legible_unique_name: Variant = false) -> Variant:
	add_child(node, legible_unique_name)
	return autofree(node)


## Adds a child to the test and calls its queue_free() after the test.
func add_child_autoqfree(node: Variant, legible_unique_name: Variant = false) -> Variant:
	add_child(node, legible_unique_name)
	return autoqfree(node)


## Calls _process and _physics_process of an object and all nodes below it, times times.
func simulate(
	obj: Variant, times: Variant, delta: Variant, check_is_processing: bool = false
) -> void:
	for i: int in int(times):
		_simulate_once(obj, delta, check_is_processing)


func begin_call() -> void:
	_orphans_before = Node.get_orphan_node_ids()


func end_call() -> void:
	# By id: a test may have freed them itself.
	for id: int in _to_free:
		if is_instance_id_valid(id):
			instance_from_id(id).free()
	for id: int in _to_queue_free:
		if is_instance_id_valid(id):
			instance_from_id(id).call(&"queue_free")
	_to_free.clear()
	_to_queue_free.clear()


func _simulate_once(obj: Object, delta: float, check_is_processing: bool) -> void:
	var node: Node = obj as Node
	if obj.has_method("_process") and (not check_is_processing or node.is_processing()):
		obj.call("_process", delta)
	if obj.has_method("_physics_process"):
		if not check_is_processing or node.is_physics_processing():
			obj.call("_physics_process", delta)
	if node != null:
		for child: Node in node.get_children():
			_simulate_once(child, delta, check_is_processing)
