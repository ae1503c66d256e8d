# SPDX-License-Identifier: MIT
## Virtual methods, notifications and engine calls of nodes.
extends "res://cases/provider_case.gd"


func test_virtual_methods_and_notifications() -> void:
	var node := ProbeNode.new()
	equal(node.get_events(), PackedStringArray(["postinitialize"]), "after construction")
	tree.root.add_child(node)
	await tree.process_frame
	await tree.process_frame
	check(node.get_frames() >= 1, "_process() is called")
	node.position = Vector3(1, 2, 3)
	tree.root.remove_child(node)
	equal(
		node.get_events(),
		PackedStringArray(
			["postinitialize", "enter_tree", "ready", "transform_changed", "exit_tree"]
		),
		"in order"
	)
	equal(str(node), "ProbeNode with %d frames" % node.get_frames(), "_to_string()")
	node.free()


func test_child_class_overrides_and_inherits() -> void:
	var child := ProbeChildNode.new()
	tree.root.add_child(child)
	await tree.process_frame
	await tree.process_frame
	equal(child.name, &"ChildIsReady", "its own _ready()")
	check(child.get_events().has("ready"), "which calls the parent's")
	check(child.get_events().has("enter_tree"), "the parent's _enter_tree()")
	check(child.get_frames() >= 1, "the parent's _process()")
	equal(child.get_frames_twice(), 2 * child.get_frames(), "its own method")
	check(child.get_child_notifications() > 3, "its own _notification(), beside the parent's")
	child.free()


func test_script_on_top() -> void:
	var script := GDScript.new()
	script.source_code = (
		"extends ProbeNode\nvar readied := 0\nfunc _ready() -> void:\n\treadied += 1\n"
		+ "func _process(_delta: float) -> void:\n\treadied += 100\n"
	)
	equal(script.reload(), OK, "the script compiles")
	var node: ProbeNode = script.new()
	tree.root.add_child(node)
	await tree.process_frame
	check(int(node.get("readied")) >= 1, "the script's _ready()")
	check(node.get_events().has("enter_tree"), "C++'s _enter_tree()")
	node.free()


func test_scene_as_cpp_sees_it() -> void:
	var node := ProbeNode.new()
	var marker := Marker3D.new()
	node.add_child(marker)
	node.position = Vector3(1, 2, 3)
	tree.root.add_child(node)
	var scene := node.describe_scene()
	equal(scene["parent"], tree.root, "parent")
	equal(scene["root_is_window"], true, "cast to a class further down")
	equal(scene["same_root"], true, "one wrapper per object")
	equal(scene["in_editor"], false, "Engine")
	equal(scene["origin"], Vector3(1, 2, 3), "transform")
	equal(scene["children"], [marker] as Array[Node], "typed array of nodes")
	equal(scene["texture_size"], Vector2i(2, 2), "texture made from an image")
	equal(node.get_picture().get_pixel(1, 1), Color8(120, 130, 140, 150), "bytes of the image")
	node.free()


func test_connection_follows_the_resource() -> void:
	var node := ProbeNode.new()
	var changes: Array[int] = []
	node.resource_changed.connect(func() -> void: changes.append(1))
	var resource := ProbeResource.new()
	node.resource = resource
	node.resource = resource
	equal(changes.size(), 1, "the signal is emitted once")
	resource.gain = 7.0
	equal(node.get_changes(), 1, "changed arrives")
	node.resource = null
	resource.gain = 8.0
	equal(node.get_changes(), 1, "disconnected")
	equal(resource.get_reference_count(), 1, "let go")
	node.free()


func test_resource_outlives_node_and_back() -> void:
	var resource := ProbeResource.new()
	var node := ProbeNode.new()
	node.resource = resource
	node.free()
	resource.gain = 6.0  # the connection of the freed node must be gone
	equal(resource.get_reference_count(), 1, "one owner")


func test_scene_file() -> void:
	var node := ProbeNode.new()
	node.name = "Probe"
	node.resource = ProbeResource.new()
	node.resource.gain = 1.25
	node.resource.data = PackedFloat32Array([1.0, 2.0])
	var scene := PackedScene.new()
	equal(scene.pack(node), OK, "packs")
	equal(ResourceSaver.save(scene, "user://probe.tscn"), OK, "saves")
	node.free()
	var loaded: PackedScene = ResourceLoader.load(
		"user://probe.tscn", "", ResourceLoader.CACHE_MODE_IGNORE
	)
	var copy: ProbeNode = loaded.instantiate()
	equal(copy.resource.gain, 1.25, "number")
	equal(copy.resource.data, PackedFloat32Array([1.0, 2.0]), "array")
	equal(copy.resource.mode, ProbeResource.MODE_RAIN, "default")
	check(
		not FileAccess.get_file_as_string("user://probe.tscn").contains("mode ="),
		"defaults are not written"
	)
	copy.free()
