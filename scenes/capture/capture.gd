# SPDX-License-Identifier: MIT
extends SceneTree
## Command line: renders stills and sequences described in JSON.
##
##     godot --path . -s res://scenes/capture/capture.gd -- SHOT.json OUT.png|OUT.exr|OUT/
##     godot --path . -s res://scenes/capture/capture.gd -- --batch LIST.json
##
## LIST.json holds a list of {"shot": FILE or object, "out": FILE}. Exits 0 when every picture was
## written, else 1 with the reason on standard error (2 for a wrong command line).

var _stage: ShotStage
var _encoder: DisplayEncoder
var _failures: int = 0


func _initialize() -> void:
	_run.call_deferred()


func _run() -> void:
	var arguments := OS.get_cmdline_user_args()
	_stage = ShotStage.new()
	_encoder = DisplayEncoder.new()
	root.add_child(_stage)
	root.add_child(_encoder)
	if arguments.size() == 2 and arguments[0] == "--batch":
		await _take_list(arguments[1])
	elif arguments.size() == 2:
		await _take(ShotSpec.from_file(arguments[0], _caller_folder()), arguments[1])
	else:
		printerr(
			"capture: give SHOT.json and an output (.png, .exr or OUT/), or --batch LIST.json."
		)
		quit(2)
		return
	quit(1 if _failures > 0 else 0)


func _take_list(list_path: String) -> void:
	var file := BoundedText.from_file(list_path, ShotSpec.MOST_BYTES)
	if not file.error.is_empty():
		_fail(list_path, file.error)
		return
	var parser := JSON.new()
	if parser.parse(file.text) != OK or parser.data is not Array:
		_fail(list_path, 'a batch is a JSON list of {"shot": ..., "out": ...}.')
		return
	var list: Array = parser.data
	var folder := list_path.get_base_dir()
	for entry: Variant in list:
		var item: Dictionary = entry if entry is Dictionary else {}
		if item.get("out") is not String:
			_fail(list_path, 'each entry needs "shot" and "out".')
			continue
		var out: String = item["out"]
		if not out.is_absolute_path():
			out = folder.path_join(out)
		var shot: Variant = item.get("shot")
		if shot is String:
			var path: String = shot
			if not path.is_absolute_path():
				path = folder.path_join(path)
			await _take(ShotSpec.from_file(path, _caller_folder()), out)
		else:
			await _take(ShotSpec.from_data(shot, [folder, _caller_folder()]), out)


func _take(spec: ShotSpec, out: String) -> void:
	var output := CaptureOutput.new(out)
	var method := RenderingServer.get_current_rendering_method()
	var reason := spec.error
	if reason.is_empty() and spec.renderer_named and method != spec.renderer:
		reason = "renderer: asked for %s, running %s." % [spec.renderer, method]
	if reason.is_empty():
		reason = output.refusal(spec, method)
	var frame_count := spec.sequence.frame_count if spec.sequence != null else 1
	var frame := 0
	while reason.is_empty() and frame < frame_count:
		reason = await _draw(spec, output, frame)
		frame += 1
		if spec.sequence != null and reason.is_empty():
			# ./run capture shows this as its progress.
			print("capture frame %d/%d" % [frame, frame_count])
	if not reason.is_empty():
		_fail(out, reason)


## Draws and writes a still or a frame; returns why it could not.
func _draw(spec: ShotSpec, output: CaptureOutput, frame: int) -> String:
	var picture: Image
	if frame == 0:
		var refusal: PackedStringArray = []
		picture = await _stage.take(spec, refusal)
		if picture == null:
			return refusal[0]
	else:
		spec.go_to(frame)
		picture = await _stage.take_next(spec)
		if picture == null:
			return "xr: the runtime gave no pictures."
	if output.kind == "png":
		picture = await _encoder.encode(picture)
	var status := output.write(picture, frame)
	if status == OK:
		return ""
	return "cannot be written (%s). Check folder and disk." % error_string(status)


func _caller_folder() -> String:
	return OS.get_environment("BLACKHOLE_CALLER_DIR")


func _fail(what: String, reason: String) -> void:
	_failures += 1
	printerr("capture: %s: %s" % [what, reason])
