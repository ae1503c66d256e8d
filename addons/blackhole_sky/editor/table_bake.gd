# SPDX-License-Identifier: MIT
@tool
extends RefCounted
## One lensing table that is computed on a worker thread and written to a file.

## The table is in the file, or the bake was cancelled or could not be written.
signal ended(bake: RefCounted, saved: bool)

## Where the table goes.
var path: String
## For whom it is made, or null.
var client: Object

var _table := LensingTable.new()


func _init(to_path: String, for_client: Object) -> void:
	path = to_path
	client = for_client


## Begins; `ended` tells the end, in a later frame.
func start() -> void:
	_table.bake_finished.connect(_on_bake_finished)
	_table.bake()


func cancel() -> void:
	_table.cancel_bake()


## From 0 to 1.
func progress() -> float:
	return _table.get_bake_progress()


func _on_bake_finished(completed: bool) -> void:
	ended.emit(self, completed and _table.save_file(path) == OK)
