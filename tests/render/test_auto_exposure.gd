# SPDX-License-Identifier: MIT
extends GutTest
## Automatic exposure in pictures: what the meter expects is what the shaders draw, and sequences
## adapt in their own time.

## Luminance to which a uniform sky is brought.
const KEY: float = 0.004

var _folder := ScratchFolder.new("auto_exposure")
var _stage: ShotStage

@warning_ignore("untyped_declaration")
func should_skip_script():
	return RendererScope.mobile_alone()


func before_all() -> void:
	var sky := Image.create_empty(128, 64, false, Image.FORMAT_RGBF)
	sky.fill(Color(0.06, 0.05, 0.04))
	sky.save_exr(_folder.file("even.exr"))


func before_each() -> void:
	_stage = ShotStage.new()
	add_child_autofree(_stage)


func _spec(more: Dictionary) -> ShotSpec:
	var shot := {
		"resolution": [64, 48],
		"vertical_fov_deg": 20,
		"renderer": RenderingServer.get_current_rendering_method(),
		"stars": null,
		"background": ProjectSettings.globalize_path(_folder.file("even.exr")),
		"exposure": "auto",
	}
	var spec := ShotSpec.from_data(shot.merged(more))
	assert_eq(spec.error, "")
	return spec


func test_an_even_sky_is_drawn_at_the_key_whatever_shifts_its_light(
	shot: Dictionary = use_parameters(
		[
			{"position_rs": [0, 0, 1000], "look_at_rs": [0, 0, 2000]},
			{"position_rs": [0, 0, 1.2], "look_at_rs": [0, 0, 5]},
			{"position_rs": [0, 0, 3], "look_at_rs": [0, 0, 5], "observer": "rain"},
			{
				"position_rs": [0, 0, 10],
				"look_at_rs": [0, 0, 20],
				"observer": {"motion": "velocity", "celerity": [0, 0, 1.5]},
			},
		]
	)
) -> void:
	if not SkyBooth.is_linear():
		pending("eight bits do not hold so little light well enough")
		return
	var picture := await _stage.take(_spec(shot), [])
	var seen := picture.get_pixel(32, 24).get_luminance()
	assert_almost_eq(seen / KEY, 1.0, 0.1)


func test_sequences_adapt_in_their_own_time() -> void:
	var path := {"fps": 10, "duration_s": 0.4}
	var far := {"t": 0, "position_rs": [0, 0, 100], "look_at_rs": [0, 0, 200]}
	var near := {"t": 0.1, "position_rs": [0, 0, 1.1], "look_at_rs": [0, 0, 5]}
	var spec := _spec({"path": path.merged({"keyframes": [far, near]})})
	var runs: Array = []
	for run in 2:
		spec.go_to(0)
		var frames: Array[float] = [(await _stage.take(spec, [])).get_pixel(32, 24).g]
		for frame in range(1, 4):
			await wait_process_frames(1 + 10 * run)
			spec.go_to(frame)
			frames.append((await _stage.take_next(spec)).get_pixel(32, 24).g)
		runs.append(frames)
	assert_eq(runs[0], runs[1], "however long the drawing takes")
	var shown: Array[float] = runs[0]
	assert_gt(shown[1], 2.0 * shown[0], "blueshifted, and not yet adapted to")
	assert_lt(shown[2], shown[1])
	assert_lt(shown[3], shown[2])
