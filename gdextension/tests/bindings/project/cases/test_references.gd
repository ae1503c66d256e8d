# SPDX-License-Identifier: MIT
## Reference counts and object lifetimes. Run under the address sanitizer this also shows that
## nothing is freed twice or used afterwards.
extends "res://cases/provider_case.gd"

var _calls := ProbeCalls.new()


func test_new_object_has_one_owner() -> void:
	var before := ProbeResource.get_live_count()
	var resource := ProbeResource.new()
	equal(ProbeResource.get_live_count(), before + 1, "one more")
	equal(resource.get_reference_count(), 1, "one owner")
	resource = null
	equal(ProbeResource.get_live_count(), before, "freed")


func test_made_in_cpp() -> void:
	var before := ProbeResource.get_live_count()
	var resource := _calls.make_resource(4.0)
	equal(resource.get_reference_count(), 1, "returned by a typed call")
	equal(resource.gain, 4.0, "the object")
	var dynamic: ProbeResource = _calls.call("make_resource", 5.0)
	equal(dynamic.get_reference_count(), 1, "returned by a dynamic call")
	_calls.make_resource(6.0)  # dropped at once
	_calls.call("make_resource", 7.0)
	resource = null
	dynamic = null
	equal(ProbeResource.get_live_count(), before, "all freed")


func test_passing_through() -> void:
	var resource := ProbeResource.new()
	check(_calls.pass_resource(resource) == resource, "the same object, typed call")
	check(_calls.call("pass_resource", resource) == resource, "the same object, dynamic call")
	equal(resource.get_reference_count(), 1, "no owner left behind")
	equal(_calls.get_count_of(resource), 2, "the argument owns while the call lasts")


func test_keeping() -> void:
	var before := ProbeResource.get_live_count()
	var resource := ProbeResource.new()
	_calls.keep(resource)
	equal(resource.get_reference_count(), 2, "kept by C++")
	resource = null
	equal(ProbeResource.get_live_count(), before + 1, "C++ alone keeps it alive")
	equal((_calls.get_kept() as ProbeResource).gain, 2.5, "and usable")
	_calls.keep(null)
	equal(ProbeResource.get_live_count(), before, "let go")


func test_engine_objects() -> void:
	var image := Image.create_empty(2, 2, false, Image.FORMAT_RGB8)
	_calls.keep(image)
	equal(image.get_reference_count(), 2, "kept by C++")
	check(_calls.get_kept() == image, "the same object")
	_calls.keep(null)
	equal(image.get_reference_count(), 1, "let go")


func test_copies_moves_and_casts() -> void:
	var facts := _calls.churn_references(100)
	equal(facts["shared"], 8, "owners at most")
	equal(facts["left"], 3, "owners left")
	equal(facts["wrong_is_null"], true, "a reference to the wrong class is null")
	equal(facts["leaked"], 0, "objects left over")


func test_subclass_in_script() -> void:
	var before := ProbeResource.get_live_count()
	var script := GDScript.new()
	script.source_code = "extends ProbeResource\nfunc louder() -> float:\n\treturn gain * 2.0\n"
	equal(script.reload(), OK, "the script compiles")
	var resource: ProbeResource = script.new()
	equal(resource.call("louder"), 5.0, "script and C++ together")
	check(_calls.pass_resource(resource) == resource, "passes as its base class")
	resource = null
	equal(ProbeResource.get_live_count(), before, "freed")


func test_nodes_are_freed_once() -> void:
	var before := ProbeNode.get_live_count()
	var resources := ProbeResource.get_live_count()
	for round_number: int in 20:
		var node := ProbeNode.new()
		node.resource = _calls.make_resource(round_number)
		tree.root.add_child(node)
		if round_number % 2 == 0:
			node.free()
		else:
			node.queue_free()
	await tree.process_frame
	await tree.process_frame
	equal(ProbeNode.get_live_count(), before, "nodes")
	equal(ProbeResource.get_live_count(), resources, "their resources")


func test_object_ids() -> void:
	var node := Node.new()
	var id := node.get_instance_id()
	check(_calls.pass_node(node) == node, "passes")
	equal(_calls.is_alive(id), true, "alive")
	equal(_calls.class_of(node), "Node", "class")
	node.free()
	equal(_calls.is_alive(id), false, "freed")


func test_object_of_an_unlisted_class() -> void:
	var timer := Timer.new()
	check(_calls.pass_node(timer) == timer, "a Timer is a Node")
	equal(_calls.class_of(timer), "Timer", "and stays a Timer")
	timer.free()


func test_duplicate() -> void:
	var resource := _calls.make_resource(3.0)
	var copy: ProbeResource = resource.duplicate()
	equal(copy.gain, 3.0, "properties are copied")
	check(copy != resource, "another object")
