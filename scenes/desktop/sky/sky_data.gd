# SPDX-License-Identifier: MIT
class_name SkyData
extends Node
## Gives the sky its lensing table, its stars and its panorama, and says what cannot be had.
##
## Nothing missing stops the scene: a table that is missing or damaged is computed anew on a worker
## thread, without a catalogue there are no stars, without a panorama there is a grid.

## Something is amiss; `topic` names the matter, a later text on it takes the place of this one.
signal warned(topic: StringName, text: String)
## The matter is settled.
signal settled(topic: StringName)

const TABLE: StringName = &"table"
const CATALOGUE: StringName = &"catalogue"
const PANORAMA: StringName = &"panorama"

@export_file("*.lut") var table_file: String = "res://addons/blackhole_sky/data/schwarzschild.lut"
@export_file("*.stars", "*.csv")
var catalogue_file: String = "res://addons/blackhole_sky/data/hipparcos.stars"
@export_file("*.exr", "*.png") var panorama_file: String = MilkyWay.FILE
@export var sky: BlackHoleSky

var _table := LensingTable.new()


func _exit_tree() -> void:
	_table.cancel_bake()


## Loads everything.
func load_all() -> void:
	_load_table()
	_load_catalogue()
	_load_panorama()


func is_computing() -> bool:
	return _table.is_baking()


func _load_table() -> void:
	_table.bake_finished.connect(_on_bake_finished)
	sky.table = _table
	if not FileAccess.file_exists(table_file):
		_compute(tr("The lensing table is missing; it is being computed …"))
	elif _table.load_file(table_file) != OK:
		_compute(tr("The lensing table is damaged; it is being computed anew …"))


func _compute(reason: String) -> void:
	_table.bake()
	warned.emit(TABLE, reason)


func _on_bake_finished(completed: bool) -> void:
	if completed:
		settled.emit(TABLE)
	elif is_inside_tree():
		warned.emit(TABLE, tr("The lensing table could not be computed: light goes straight."))


func _load_catalogue() -> void:
	if not FileAccess.file_exists(catalogue_file):
		warned.emit(
			CATALOGUE, tr("There is no star catalogue %s: no stars are shown.") % catalogue_file
		)
		return
	var catalogue := StarCatalogue.new()
	if catalogue.load_file(catalogue_file) != OK:
		warned.emit(
			CATALOGUE,
			(
				tr("The star catalogue cannot be read: no stars are shown.")
				+ "\n"
				+ catalogue.get_error_message()
			)
		)
		return
	sky.catalogue = catalogue


func _load_panorama() -> void:
	var panorama: Texture2D = null
	if ResourceLoader.exists(panorama_file):
		panorama = load(panorama_file) as Texture2D
	if panorama == null:
		warned.emit(PANORAMA, tr("The Milky Way picture is missing: a grid takes its place."))
		sky.background = BlackHoleSky.BACKGROUND_GRID
		return
	sky.panorama = panorama
	sky.panorama_luminance = MilkyWay.LUMINANCE
	sky.background = BlackHoleSky.BACKGROUND_PANORAMA
