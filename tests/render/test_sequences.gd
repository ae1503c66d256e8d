# SPDX-License-Identifier: MIT
extends GutTest
## Sequences: every frame is the picture of its place, and nothing jumps at the horizon.

const SCRIPT: String = "res://scenes/capture/capture.gd"
## Change from frame to frame at the horizon against the largest before it.
const LARGEST_GROWTH: float = 1.5
## Frames with the eye this near to the horizon, in Schwarzschild radii, are at it.
const NEAR: float = 0.03

var _folder := ScratchFolder.new("sequences")
var _stage: ShotStage

@warning_ignore("untyped_declaration")
func should_skip_script():
	return RendererScope.mobile_alone()


func before_all() -> void:
	_smooth_sky().save_exr(_folder.file("smooth.exr"))


func before_each() -> void:
	_stage = ShotStage.new()
	add_child_autofree(_stage)


func test_the_capture_command_writes_each_frame_of_a_fall() -> void:
	var shot := _fall({"from_rs": 1.4, "to_rs": 0.6}, 6)
	var text := JSON.stringify(shot)
	var shot_file := ProjectSettings.globalize_path(_folder.write_text("fall.json", text))
	var pattern := ProjectSettings.globalize_path(_folder.file("fall_%02d.png"))
	var runs: Array = []
	for run in 2:
		var said: Array = []
		assert_eq(_capture([shot_file, pattern], said), 0, "%s" % [said])
		assert_string_contains(said[0], "capture frame 6/6")
		var frames: Array[PackedByteArray] = []
		for frame in 7:
			frames.append(FileAccess.get_file_as_bytes(_folder.file("fall_%02d.png" % frame)))
		runs.append(frames)
	assert_eq(runs[0], runs[1], "the same to the bit from run to run")
	assert_true(runs[0][6].is_empty(), "six frames")
	assert_eq(DirAccess.get_files_at(_folder.path).size(), 8, "the sky, the shot and six frames")
	await _expect_stills(shot, runs[0])


func test_frames_with_overlays_names_and_diffraction_lag_behind_nothing() -> void:
	var shot := {
		"resolution": [320, 240],
		"renderer": RenderingServer.get_current_rendering_method(),
		"observer": {"motion": "velocity", "beta": [0.3, 0, 0]},
		"background": "milky_way",
		"stars": {"magnitude_limit": 5},
		"psf": {"model": "airy", "aperture_mm": 2},
		"overlays": ["constellations", "star_names", "equatorial_grid", "shadow_edge", "motion"],
	}
	var keyframes: Array = [
		{"t": 0, "position_rs": [0, 0, 10], "vertical_fov_deg": 40},
		{"t": 1, "position_rs": [8, 2, 3], "vertical_fov_deg": 90},
	]
	var path := {"fps": 4, "duration_s": 1, "keyframes": keyframes}
	var spec := ShotSpec.from_data(shot.merged({"path": path}))
	assert_eq(spec.error, "")
	var refusal: PackedStringArray = []
	var pictures: Array[Image] = [await _stage.take(spec, refusal)]
	for frame: int in [1, 2, 3]:
		spec.go_to(frame)
		pictures.append(await _stage.take_next(spec))
	for frame: int in [3, 1]:
		spec.go_to(frame)
		var still := (
			ShotSpec
			. from_data(
				(
					shot
					. merged(
						{
							"position_rs": Array(spec.position),
							"vertical_fov_deg": spec.vertical_fov_deg,
						}
					)
				)
			)
		)
		assert_eq(still.error, "")
		var picture: Image = await _stage.take(still, refusal)
		assert_eq(refusal.size(), 0)
		_expect_same(pictures[frame], picture, frame)
		assert_ne(pictures[frame - 1].get_data(), picture.get_data(), "the eye moves")


func test_nothing_jumps_at_the_horizon() -> void:
	await _expect_even({"from_rs": 3, "to_rs": 0.3}, 60)


func test_nothing_jumps_at_the_horizon_in_600_frames() -> void:
	if not RendererScope.is_everything_wanted():
		pending("600 frames, twice; ./test --all draws them")
		return
	# In the Compatibility renderer less than a step of 8 bits changes from frame to frame.
	if SkyBooth.is_linear():
		await _expect_even({"from_rs": 3, "to_rs": 0.3}, 600)
	# At even steps of proper time the whole ride is fast here: 0.18 r_s a frame.
	await _expect_even({"from_rs": 30, "to_rs": 0.05}, 600)


## Each frame is to the bit the still that is taken from its place, whatever was drawn before.
func _expect_stills(shot: Dictionary, frames: Array[PackedByteArray]) -> void:
	var spec := ShotSpec.from_data(shot)
	var encoder := DisplayEncoder.new()
	add_child_autofree(encoder)
	for frame: int in [5, 0, 3]:
		spec.go_to(frame)
		var still := shot.duplicate()
		still.erase("path")
		still["position_rs"] = Array(spec.position)
		still["observer"] = "rain"
		var refusal: PackedStringArray = []
		var still_spec := ShotSpec.from_data(still)
		assert_eq(still_spec.error, "")
		var picture: Image = await _stage.take(still_spec, refusal)
		picture = await encoder.encode(picture)
		var written := Image.new()
		assert_eq(written.load_png_from_buffer(frames[frame]), OK)
		assert_eq(written.get_size(), Vector2i(64, 48))
		_expect_same(written, picture, frame)


func _expect_same(frame_picture: Image, still: Image, frame: int) -> void:
	var same := frame_picture.get_data() == still.get_data()
	assert_true(same, "frame %d is the still to the bit" % frame)


## The median over the pixels of the change from frame to frame: at the horizon it is at most
## LARGEST_GROWTH times what it was before.
func _expect_even(ride: Dictionary, frame_count: int) -> void:
	var spec := ShotSpec.from_data(_fall(ride, frame_count))
	assert_eq(spec.error, "")
	var refusal: PackedStringArray = []
	var pictures: Array[PackedFloat32Array] = []
	var radii: PackedFloat64Array = []
	for frame in frame_count:
		spec.go_to(frame)
		var picture: Image
		if frame == 0:
			picture = await _stage.take(spec, refusal)
		else:
			picture = await _stage.take_next(spec)
		pictures.append(PictureMeasure.of_image(picture).luminance)
		radii.append(Vec3D.length(spec.position))
	var before := 0.0
	var there := 0.0
	# What a frame left out at the horizon looks like.
	var gap := 0.0
	for frame in range(1, frame_count):
		if radii[frame] >= 1.0 + NEAR:
			before = maxf(before, _median_change(pictures[frame - 1], pictures[frame]))
		elif radii[frame - 1] >= 1.0 - NEAR:
			there = maxf(there, _median_change(pictures[frame - 1], pictures[frame]))
			gap = maxf(gap, _median_change(pictures[frame - 1], pictures[frame + 1]))
	gut.p(
		(
			"%s, %d frames: median change %.5f before, %.5f at the horizon; with a gap %.5f"
			% [ride, frame_count, before, there, gap]
		)
	)
	assert_gt(before, 0.0)
	assert_gt(there, 0.0)
	assert_lte(there, LARGEST_GROWTH * before)
	assert_gt(gap, LARGEST_GROWTH * before, "a jump would be found")


func _median_change(a: PackedFloat32Array, b: PackedFloat32Array) -> float:
	var changes: PackedFloat32Array = []
	for i in a.size():
		changes.append(absf(a[i] - b[i]))
	changes.sort()
	@warning_ignore("integer_division")
	return changes[changes.size() / 2]


## Rain past the horizon, the camera aside, where sky is seen all the way.
func _fall(ride: Dictionary, frame_count: int) -> Dictionary:
	var path := {"fps": 60, "duration_s": frame_count / 60.0, "ride": ride.merged({"kind": "fall"})}
	return {
		"resolution": [64, 48],
		"look_at_rs": [1e6, 2e5, 0],
		"background": ProjectSettings.globalize_path(_folder.file("smooth.exr")),
		"renderer": RenderingServer.get_current_rendering_method(),
		"path": path,
	}


## Luminance in waves some 20 degrees long all over the sky.
func _smooth_sky() -> Image:
	var image := Image.create_empty(512, 256, false, Image.FORMAT_RGBF)
	for y in 256:
		for x in 512:
			var declination := PI * (0.5 - (y + 0.5) / 256.0)
			var ascension := TAU * (0.25 - (x + 0.5) / 512.0)
			var star := cos(declination) * Vector2(cos(ascension), -sin(ascension))
			var waves := (
				sin(20.0 * star.x) + sin(20.0 * star.y + 1.0) + sin(20.0 * sin(declination))
			)
			image.set_pixel(x, y, Color.WHITE * (0.3 + 0.09 * waves))
	return image


func _capture(arguments: PackedStringArray, said: Array) -> int:
	var command: PackedStringArray = [
		"--path",
		ProjectSettings.globalize_path("res://"),
		"--rendering-method",
		RenderingServer.get_current_rendering_method(),
		"--audio-driver",
		"Dummy",
		"-s",
		SCRIPT,
		"--",
	]
	return OS.execute(OS.get_executable_path(), command + arguments, said, true)
