# SPDX-License-Identifier: MIT
@tool
extends EditorNode3DGizmoPlugin
## Draws the edges of each AccretionDisk and the innermost stable orbit in the 3D view.

const DiskLines := preload("disk_lines.gd")
const LineMaterial := preload("line_material.gd")
const LinesGizmo := preload("lines_gizmo.gd")


func _init() -> void:
	add_material("innermost_stable", LineMaterial.make(Color(0.3, 0.85, 1.0)))
	add_material("inner_edge", LineMaterial.make(Color(1.0, 0.5, 0.75)))
	add_material("outer_edge", LineMaterial.make(Color(0.75, 0.55, 1.0)))
	add_material("rings", LineMaterial.make(Color(0.75, 0.55, 1.0)))


func _get_gizmo_name() -> String:
	return "AccretionDisk"


func _create_gizmo(for_node: Node3D) -> EditorNode3DGizmo:
	return LinesGizmo.new(DiskLines.of) if for_node is AccretionDisk else null
