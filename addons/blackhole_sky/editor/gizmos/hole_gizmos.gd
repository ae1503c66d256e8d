# SPDX-License-Identifier: MIT
@tool
extends EditorNode3DGizmoPlugin
## Draws the horizon, the photon sphere, the far shadow and orbits of each BlackHoleSky in the 3D
## view.

const HoleLines := preload("hole_lines.gd")
const LineMaterial := preload("line_material.gd")
const LinesGizmo := preload("lines_gizmo.gd")
const FACING: Array[StringName] = [&"shadow"]


func _init() -> void:
	add_material("horizon", LineMaterial.make(Color(1.0, 0.35, 0.25)))
	add_material("photon_sphere", LineMaterial.make(Color(1.0, 0.8, 0.25)))
	add_material("shadow", LineMaterial.make(Color(0.85, 0.9, 1.0), true))
	add_material("orbit", LineMaterial.make(Color(0.35, 0.95, 0.55)))


func _get_gizmo_name() -> String:
	return "BlackHoleSky"


func _create_gizmo(for_node: Node3D) -> EditorNode3DGizmo:
	return LinesGizmo.new(HoleLines.of, FACING) if for_node is BlackHoleSky else null
