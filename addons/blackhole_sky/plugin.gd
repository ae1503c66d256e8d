# SPDX-License-Identifier: MIT
@tool
extends EditorPlugin
## Editor side of the addon: adds gizmos, buttons in the inspector, an importer, a page of project
## settings and an item of the Tools menu, and takes them away again.

const DiskGizmos := preload("editor/gizmos/disk_gizmos.gd")
const HoleGizmos := preload("editor/gizmos/hole_gizmos.gd")
const NewSkies := preload("editor/new_skies.gd")
const ProjectPage := preload("editor/project_page.gd")
const SkyInspector := preload("editor/inspector/sky_inspector.gd")
const StarCsvImporter := preload("editor/importers/star_csv_importer.gd")
const TableBaker := preload("editor/table_baker.gd")

const TABLE_FILE: String = "res://addons/blackhole_sky/data/schwarzschild.lut"
const MENU_ITEM: String = "Black Hole Sky: bake lensing table"

var baker := TableBaker.new()
var _gizmos: Array[EditorNode3DGizmoPlugin] = [HoleGizmos.new(), DiskGizmos.new()]
var _inspector := SkyInspector.new(baker)
var _importer := StarCsvImporter.new()
var _new_skies := NewSkies.new()


func _enter_tree() -> void:
	ProjectPage.add()
	add_tool_menu_item(MENU_ITEM, baker.bake.bind(null, TABLE_FILE))
	for gizmo in _gizmos:
		add_node_3d_gizmo_plugin(gizmo)
	add_inspector_plugin(_inspector)
	add_import_plugin(_importer)
	_new_skies.watch(get_tree())


func _exit_tree() -> void:
	_new_skies.leave()
	remove_import_plugin(_importer)
	remove_inspector_plugin(_inspector)
	for gizmo in _gizmos:
		remove_node_3d_gizmo_plugin(gizmo)
	remove_tool_menu_item(MENU_ITEM)
	baker.leave()
	ProjectPage.remove()
