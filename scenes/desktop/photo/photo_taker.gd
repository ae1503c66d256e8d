# SPDX-License-Identifier: MIT
class_name PhotoTaker
extends Node
## Takes a shot as ./run capture does and writes it with the shot's JSON beside it, on a worker
## thread.

## Both files are there.
signal saved(picture: String, shot: String)
## They are not; the reason is in the language of the display.
signal failed(reason: String)

var _stage: ShotStage
var _encoder: DisplayEncoder
var _is_busy: bool = false
var _task: int = -1
# The worker's; nobody else touches them until it is done.
var _picture: Image
var _output: CaptureOutput
var _json: String
var _shot_path: String
var _status: Error = OK


func _ready() -> void:
	set_process(false)


func _exit_tree() -> void:
	if _task >= 0:
		WorkerThreadPool.wait_for_task_completion(_task)
		_task = -1


func _process(_delta: float) -> void:
	if _task < 0 or not WorkerThreadPool.is_task_completed(_task):
		return
	WorkerThreadPool.wait_for_task_completion(_task)
	_task = -1
	_finish()


func is_busy() -> bool:
	return _is_busy


## Takes `described` and writes it under `path`, to which `kind` ("png" or "exr") is added. `sky` is
## the one that was described: what it has read is not read again.
func take(described: ShotFromScene, path: String, kind: String, sky: BlackHoleSky) -> void:
	if _is_busy:
		return
	_is_busy = true
	_output = CaptureOutput.new(path + "." + kind)
	_json = described.to_json()
	_shot_path = path + ".json"
	var spec := ShotSpec.from_data(JSON.parse_string(_json))
	var refusal := PackedStringArray()
	if not described.refusal.is_empty():
		refusal.append(described.refusal)
	elif not spec.error.is_empty():
		refusal.append(spec.error)
	else:
		_picture = await _draw(spec, refusal, sky)
	if not refusal.is_empty():
		_fail(refusal[0])
		return
	_task = WorkerThreadPool.add_task(_write, false, "Photo")
	set_process(true)


## Frees what taking pictures takes; the next photo sets it up again.
func rest() -> void:
	if _stage != null and not _is_busy:
		_stage.queue_free()
		_encoder.queue_free()
		_stage = null
		_encoder = null


func _draw(spec: ShotSpec, refusal: PackedStringArray, sky: BlackHoleSky) -> Image:
	if _stage == null:
		_stage = ShotStage.new()
		_encoder = DisplayEncoder.new()
		add_child(_stage)
		add_child(_encoder)
	_stage.borrow(sky)
	var picture := await _stage.take(spec, refusal)
	if picture == null or _output.kind == "exr":
		return picture
	return await _encoder.encode(picture)


# On a worker thread.
func _write() -> void:
	var folder := _shot_path.get_base_dir()
	DirAccess.make_dir_recursive_absolute(folder)
	_status = OK if DirAccess.dir_exists_absolute(folder) else ERR_CANT_CREATE
	if _status == OK:
		_status = _output.write(_picture)
	if _status == OK:
		_status = _write_shot()


func _write_shot() -> Error:
	var part := _shot_path + ".part"
	var file := FileAccess.open(part, FileAccess.WRITE)
	if file == null:
		return FileAccess.get_open_error()
	var is_written := file.store_string(_json)
	file.close()
	return DirAccess.rename_absolute(part, _shot_path) if is_written else ERR_FILE_CANT_WRITE


func _finish() -> void:
	set_process(false)
	_picture = null
	if _status == OK:
		_is_busy = false
		saved.emit(_output.file(), _shot_path)
	else:
		var text := tr("%s cannot be written (%s). Check folder and disk.")
		_fail(text % [_output.file(), error_string(_status)])


func _fail(reason: String) -> void:
	_is_busy = false
	_picture = null
	failed.emit(reason)
