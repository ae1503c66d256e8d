# SPDX-License-Identifier: MIT
extends SceneTree
## Command line: renders stills described in JSON.
##
##     godot --path . -s res://scenes/capture/capture.gd -- SHOT.json OUT.png|OUT.exr
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
		printerr("capture: give SHOT.json and an output file (.png or .exr), or --batch LIST.json.")
		quit(2)
		return
	quit(1 if _failures > 0 else 0)


func _take_list(list_path: String) -> void:
	var parsed: Variant = JSON.parse_string(FileAccess.get_file_as_string(list_path))
	if parsed is not Array:
		_fail(list_path, 'a batch is a JSON list of {"shot": ..., "out": ...}.')
		return
	var list: Array = parsed
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
	var kind := out.get_extension().to_lower()
	if not spec.error.is_empty():
		_fail(out, spec.error)
		return
	if kind != "png" and kind != "exr":
		_fail(out, "the output must end in .png or .exr.")
		return
	var method := RenderingServer.get_current_rendering_method()
	if spec.renderer_named and method != spec.renderer:
		_fail(out, "renderer: asked for %s, running %s." % [spec.renderer, method])
		return
	if kind == "exr" and method != "forward_plus":
		_fail(
			out, "renderer: scene-linear .exr needs forward_plus; %s rounds too coarsely." % method
		)
		return
	var refusal: PackedStringArray = []
	var picture: Image = await _stage.take(spec, refusal)
	if picture == null:
		_fail(out, refusal[0])
		return
	DirAccess.make_dir_recursive_absolute(out.get_base_dir())
	var status: Error
	if kind == "exr":
		status = picture.save_exr(out)
	else:
		picture = await _encoder.encode(picture)
		status = picture.save_png(out)
	if status != OK:
		_fail(out, "cannot be written (%s). Check folder and disk." % error_string(status))


func _caller_folder() -> String:
	return OS.get_environment("BLACKHOLE_CALLER_DIR")


func _fail(what: String, reason: String) -> void:
	_failures += 1
	printerr("capture: %s: %s" % [what, reason])
