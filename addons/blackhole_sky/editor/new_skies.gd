# SPDX-License-Identifier: MIT
@tool
extends RefCounted
## Gives each sky that is newly added to a scene its data, so that it shows something at once.
##
## A sky that comes with its scene, by opening it or by turning to its tab, is left as its maker
## left it.

const ProjectPage := preload("project_page.gd")
const SkyDefaults := preload("sky_defaults.gd")

var _tree: SceneTree
var _seen: Dictionary[int, bool] = {}
var _root: Node
var _root_came: int = -1


## Begins to watch.
func watch(tree: SceneTree) -> void:
	_tree = tree
	_tree.node_added.connect(_on_node_added)


## Ends it.
func leave() -> void:
	_tree.node_added.disconnect(_on_node_added)


func _on_node_added(node: Node) -> void:
	var root := EditorInterface.get_edited_scene_root()
	if node == root:
		_root = root
		_root_came = Engine.get_process_frames()
	var sky := node as BlackHoleSky
	if sky == null or _seen.has(sky.get_instance_id()):
		return
	_seen[sky.get_instance_id()] = true
	var comes_with_scene := _root == root and _root_came == Engine.get_process_frames()
	_greet.call_deferred(sky.get_instance_id(), comes_with_scene)


## Later, when the editor has said whose the node is.
func _greet(id: int, came_with_scene: bool) -> void:
	var sky := instance_from_id(id) as BlackHoleSky
	if sky == null or not sky.is_inside_tree() or not ProjectPage.value(ProjectPage.GIVE_DATA):
		return
	var root := EditorInterface.get_edited_scene_root()
	var is_new_scene := sky == root and sky.scene_file_path.is_empty()
	var is_part := sky.owner == root and not came_with_scene
	if (is_part or is_new_scene) and SkyDefaults.is_bare(sky):
		SkyDefaults.give(sky, SkyDefaults.of_new(sky))
