# SPDX-License-Identifier: MIT
extends SceneTree
## Command line: times drawing, the node's own work and loading, and writes the figures as JSON.
##
##     godot --path . --rendering-method R -s res://scenes/bench/bench.gd -- OUT.json [MANY.stars]
##
## A catalogue of millions of stars is measured when given. `./run bench` adds what is measured
## outside of the engine and prints the table.

const WINDOW_SIZE := Vector2i(64, 64)


func _initialize() -> void:
	_run.call_deferred()


func _run() -> void:
	var arguments := OS.get_cmdline_user_args()
	if arguments.size() < 1 or arguments.size() > 2:
		printerr("bench: give the output file and, if wanted, a large catalogue.")
		quit(2)
		return
	DisplayServer.window_set_vsync_mode(DisplayServer.VSYNC_DISABLED)
	Engine.max_fps = 0
	# The window itself shall cost next to nothing.
	DisplayServer.window_set_size(WINDOW_SIZE)
	root.disable_3d = true
	var stage := BenchStage.new()
	root.add_child(stage)
	var panorama := BenchPanorama.find()
	var missing := stage.dress(panorama.texture, panorama.luminance)
	if not missing.is_empty():
		_fail(missing)
		return
	var figures := {
		"renderer": RenderingServer.get_current_rendering_method(),
		"device": RenderingServer.get_video_adapter_name(),
		"device_vendor": RenderingServer.get_video_adapter_vendor(),
		"device_api": RenderingServer.get_video_adapter_api_version(),
		"processor": OS.get_processor_name(),
		"processor_threads": OS.get_processor_count(),
		"godot": Engine.get_version_info()["string"],
		"resolution": [BenchStage.SIZE.x, BenchStage.SIZE.y],
		"panorama": panorama.name,
	}
	figures["catalogue_load_ms"] = NodeTimes.catalogue_load_ms()
	figures.merge(await NodeTimes.update_ms(stage))
	figures.merge(await _gpu_times(stage))
	if arguments.size() == 2:
		var scale := await ScaleTimes.measure(stage, arguments[1])
		if scale.is_empty():
			_fail("%s cannot be read." % arguments[1])
			return
		figures.merge(scale)
	figures["march_picture"] = await MarchCheck.compare(stage)
	var file := FileAccess.open(arguments[0], FileAccess.WRITE)
	if file == null or not file.store_string(JSON.stringify(figures, "\t", false, true) + "\n"):
		_fail("%s cannot be written. Check folder and disk." % arguments[0])
		return
	file.close()
	quit(0)


func _gpu_times(stage: BenchStage) -> Dictionary:
	var sampler := GpuSampler.new(stage)
	var quick: Array[BenchStage.Picture] = []
	for picture: BenchStage.Picture in BenchStage.Picture.values():
		if picture != BenchStage.Picture.MARCH_1000:
			quick.append(picture)
	await sampler.measure(quick)
	await sampler.measure_slow(BenchStage.Picture.MARCH_1000)
	var net := {}
	var turns := {}
	for key: String in BenchStage.Picture:
		var picture: BenchStage.Picture = BenchStage.Picture[key]
		var name := key.to_lower()
		turns[name] = sampler.get_turns(picture)
		net[name] = sampler.get_least(picture)
		if picture != BenchStage.Picture.EMPTY:
			net[name] = maxf(net[name] - sampler.get_least(BenchStage.Picture.EMPTY), 0.0)
	return {"gpu_ms": net, "gpu_turns_ms": turns}


func _fail(reason: String) -> void:
	printerr("bench: %s" % reason)
	quit(1)
