# SPDX-License-Identifier: MIT
extends GutTest
## Sequences of a shot: how many frames, where keyframes put the eye, what is refused and when.

const DIAGONAL: float = 0.70710678118654752


func test_a_still_has_no_path() -> void:
	assert_null(ShotSpec.from_data({"position_rs": [0, 0, 10]}).sequence)


func test_how_many_frames(
	# frames per second, seconds, frames
	p: Array = use_parameters(
		[[30, 20, 600], [25, 0.5, 13], [24, 0.01, 1], [240, 3600, 864000], [23.976, 10, 240]]
	)
) -> void:
	var path := {"fps": p[0], "duration_s": p[1], "ride": {"kind": "orbit", "from_rs": 3}}
	assert_eq(ShotPath.from_data({"path": path}).frame_count, int(p[2]))


func test_the_spec_is_that_of_the_frame_gone_to() -> void:
	var spec := _keyframes([_at(0, [0, 0, 20]), _at(2, [0, 0, 10])])
	assert_eq(spec.error, "")
	assert_eq(spec.sequence.frame_count, 20)
	assert_eq(spec.position, PackedFloat64Array([0.0, 0.0, 20.0]))
	for frame: int in [10, 19, 0]:
		spec.go_to(frame)
		_expect(spec.position, [0.0, 0.0, 20.0 - 0.5 * frame])
		_expect(spec.forward, [0.0, 0.0, -1.0])
		assert_eq(spec.vertical_fov_deg, 60.0)


func test_before_the_first_and_after_the_last_keyframe_the_eye_rests() -> void:
	var spec := _keyframes([_at(0.5, [0, 0, 20]), _at(1, [0, 0, 10])])
	for frame: int in [0, 5]:
		spec.go_to(frame)
		assert_eq(spec.position[2], 20.0)
	spec.go_to(19)
	assert_eq(spec.position[2], 10.0)


func test_fields_of_view_change_by_even_factors() -> void:
	var first := _at(0, [0, 0, 20], {"vertical_fov_deg": 64})
	var spec := _keyframes([first, _at(2, [0, 0, 20], {"vertical_fov_deg": 1})])
	for frame: int in [0, 5, 10, 15]:
		spec.go_to(frame)
		assert_almost_eq(spec.vertical_fov_deg, 64.0 * pow(64.0, -frame / 20.0), 1e-9)


func test_aims_and_upward_directions_turn_from_one_keyframe_to_the_next() -> void:
	var first := _at(0, [0, 0, 20], {"look_at_rs": [0, 0, 0], "up": [0, 7, 0]})
	var second := _at(2, [0, 0, 20], {"look_at_rs": [40, 0, 20], "up": [0, 0, 0.1]})
	var spec := _keyframes([first, second], {"background": "grid"})
	assert_eq(spec.error, "")
	spec.go_to(10)
	# Half the way the point aimed at is (20, 0, 10).
	_expect(spec.forward, Vec3D.normalized([20.0, 0.0, -10.0]))
	assert_gt(spec.up[1], 0.5)
	assert_gt(spec.up[2], 0.2)
	assert_almost_eq(Vec3D.dot(spec.up, spec.forward), 0.0, 1e-12)


func test_what_a_keyframe_leaves_out_is_as_the_shot_says() -> void:
	var keys := {"look_at_rs": [0, 0, 100], "up": [1, 0, 0], "vertical_fov_deg": 25}
	var spec := _keyframes([_at(0, [0, 0, 20]), _at(2, [0, 0, 10])], keys)
	spec.go_to(7)
	_expect(spec.forward, [0.0, 0.0, 1.0])
	_expect(spec.up, [1.0, 0.0, 0.0])
	assert_eq(spec.vertical_fov_deg, 25.0)
	# One that says more than the other starts from the same.
	var second := _at(2, [0, 0, 10], {"up": [0, 1, 0], "look_at_rs": [0, 0, 50]})
	spec = _keyframes([_at(0, [0, 0, 20]), second], keys)
	_expect(spec.up, [1.0, 0.0, 0.0])
	_expect(spec.forward, [0.0, 0.0, 1.0])
	spec.go_to(10)
	_expect(spec.up, [DIAGONAL, DIAGONAL, 0.0])


func test_the_upward_direction_does_not_depend_on_the_frames_before() -> void:
	var shot := [_at(0, [0, 0, 20]), _at(1, [0, 19, 1]), _at(2, [0, 0, 10])]
	var spec := _keyframes(shot)
	spec.go_to(12)
	var straight := spec.up.duplicate()
	for frame in 13:
		spec.go_to(frame)
	assert_eq(spec.up, straight)


func test_the_observer_holds_throughout() -> void:
	var orbit := {"observer": {"motion": "orbit"}, "aim": "apparent"}
	var spec := _keyframes([_at(0, [0, 0, 20]), _at(2, [0, 0, 4])], orbit)
	assert_eq(spec.error, "")
	for frame: int in [0, 11]:
		spec.go_to(frame)
		assert_eq(spec.observer.motion, LensingTable.MOTION_ORBIT)
		# The hole is seen ahead of where it is: aberration at a beta of 1/sqrt(2 (r - 1)).
		assert_gt(absf(spec.forward[0]), 0.1)


func test_what_stops_existing_is_refused_with_the_time() -> void:
	# At 10 frames a second the eye is at r = 1 in frame 19.
	var keyframes: Array = [_at(0, [0, 0, 20]), _at(1.9, [0, 0, 1])]
	var spec := _keyframes(keyframes)
	assert_string_contains(spec.error, "path: at 1.9 s (frame 19): observer: no observer can be")
	assert_eq(_keyframes(keyframes, {"observer": "rain"}).error, "")
	spec = _keyframes([_at(0, [0, 0, 1]), _at(2, [0, 0, -1])], {"observer": "rain"})
	assert_string_contains(spec.error, "path: at 1 s (frame 10): position_rs lies in the singu")


func _keyframes(keyframes: Array, keys: Dictionary = {}) -> ShotSpec:
	var path := {"fps": 10, "duration_s": 2, "keyframes": keyframes}
	return ShotSpec.from_data(keys.merged({"path": path}))


func _at(time: float, place: Array, keys: Dictionary = {}) -> Dictionary:
	return keys.merged({"t": time, "position_rs": place})


func _expect(got: PackedFloat64Array, expected: PackedFloat64Array) -> void:
	assert_lt(Vec3D.length(Vec3D.subtract(got, expected)), 1e-12, "%s, not %s" % [got, expected])
