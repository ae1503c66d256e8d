# SPDX-License-Identifier: MIT
@tool
extends VBoxContainer
## Buttons in the inspector of a sky, a table or a catalogue: bake the table, read the data anew,
## get what is missing.

const DataReader := preload("data_reader.gd")
const SkyDefaults := preload("../sky_defaults.gd")
const TableBaker := preload("../table_baker.gd")
const NEW_TABLE: String = "schwarzschild.lut"

var _edited: Object
var _baker: TableBaker
var _bake: Button
var _cancel: Button
var _progress: ProgressBar
var _give: Button


func _init(edited: Object, baker: TableBaker) -> void:
	_edited = edited
	_baker = baker


func _ready() -> void:
	var row := HBoxContainer.new()
	add_child(row)
	if not _edited is StarCatalogue:
		_add_bake(row)
	var rebuild := _button(
		"Rebuild", "Read the files anew and give the graphics card everything again", row
	)
	rebuild.pressed.connect(_on_rebuild_pressed)
	if _edited is BlackHoleSky:
		_give = _button("Use Default Data", "Set what is missing: table, stars, background", self)
		_give.pressed.connect(_on_give_pressed)
	_show_state()


func _process(_delta: float) -> void:
	_show_state()


func _add_bake(row: Container) -> void:
	_bake = _button("Bake Table", "Compute the lensing table anew and keep it in its file", row)
	_bake.pressed.connect(_on_bake_pressed)
	_progress = ProgressBar.new()
	_progress.max_value = 1.0
	_progress.size_flags_horizontal = Control.SIZE_EXPAND_FILL
	row.add_child(_progress)
	_cancel = _button("Cancel", "Stop computing; the table stays as it was", row)
	_cancel.pressed.connect(_on_cancel_pressed)


func _button(label: String, tooltip: String, into: Container) -> Button:
	var button := Button.new()
	button.text = label
	button.tooltip_text = tooltip
	button.size_flags_horizontal = Control.SIZE_EXPAND_FILL
	into.add_child(button)
	return button


func _show_state() -> void:
	if not is_instance_valid(_edited):
		return
	if _bake != null:
		var bake := _baker.bake_of(_client())
		_bake.visible = bake == null
		_progress.visible = bake != null
		_cancel.visible = bake != null
		_progress.value = bake.progress() if bake != null else 0.0
	if _give != null:
		var sky: BlackHoleSky = _edited
		_give.visible = sky.table == null or sky.catalogue == null


## Whose table is baked: that of the sky, or the sky's to be.
func _client() -> Object:
	var sky := _edited as BlackHoleSky
	return sky.table if sky != null and sky.table != null else _edited


func _on_bake_pressed() -> void:
	var table := _client() as LensingTable
	var path := TableBaker.file_of(table) if table != null else ""
	if path.is_empty():
		_ask_for_file()
	else:
		_baker.bake(table, path)


func _ask_for_file() -> void:
	var dialog := EditorFileDialog.new()
	dialog.file_mode = FileDialog.FILE_MODE_SAVE_FILE
	dialog.add_filter("*.lut", "Lensing table")
	dialog.current_path = "res://".path_join(NEW_TABLE)
	dialog.file_selected.connect(func(path: String) -> void: _baker.bake(_client(), path))
	dialog.visibility_changed.connect(
		func() -> void:
			if not dialog.visible:
				dialog.queue_free()
	)
	EditorInterface.popup_dialog_centered_ratio(dialog, 0.5)


func _on_cancel_pressed() -> void:
	var bake := _baker.bake_of(_client())
	if bake != null:
		bake.cancel()


func _on_rebuild_pressed() -> void:
	DataReader.read_anew(_edited)


func _on_give_pressed() -> void:
	var sky: BlackHoleSky = _edited
	SkyDefaults.give(sky, SkyDefaults.missing(sky))
