# SPDX-License-Identifier: MIT
@tool
extends EditorInspectorPlugin
## Puts the buttons of [code]sky_buttons.gd[/code] above the properties of skies, tables and
## catalogues.

const SkyButtons := preload("sky_buttons.gd")
const TableBaker := preload("../table_baker.gd")

var _baker: TableBaker


func _init(baker: TableBaker) -> void:
	_baker = baker


func _can_handle(object: Object) -> bool:
	return object is BlackHoleSky or object is LensingTable or object is StarCatalogue


func _parse_begin(object: Object) -> void:
	add_custom_control(SkyButtons.new(object, _baker))
