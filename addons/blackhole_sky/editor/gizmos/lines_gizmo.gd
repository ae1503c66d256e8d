# SPDX-License-Identifier: MIT
@tool
extends EditorNode3DGizmo
## A gizmo of named lines, each in the colour that its plugin has under that name. A click on one
## selects the node.

## What is drawn; by name, in the node's axes.
var lines: Dictionary[StringName, PackedVector3Array] = {}

var _lines_of: Callable
var _facing: Array[StringName] = []


## `lines_of` gives a node's lines; those whose names are in `facing` are turned to the camera.
func _init(lines_of: Callable, facing: Array[StringName] = []) -> void:
	_lines_of = lines_of
	_facing = facing


func _redraw() -> void:
	clear()
	lines = {}
	if not get_node_3d().is_inside_tree():
		return
	lines = _lines_of.call(get_node_3d())
	for line: StringName in lines:
		if lines[line].is_empty():
			continue
		var turned := line in _facing
		add_lines(lines[line], get_plugin().get_material(line, self), turned)
		if not turned:
			add_collision_segments(lines[line])
