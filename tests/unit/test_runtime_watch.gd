# SPDX-License-Identifier: MIT
extends GutTest
## A dead runtime is told from a quick or a still one.

const STILL := Transform3D.IDENTITY
const RATE: float = 90.0


func test_frames_that_come_in_time_are_alive() -> void:
	assert_false(_after(200, 1.0 / RATE, false).is_dead())


func test_frames_that_rush_while_the_head_stands_still_are_not() -> void:
	assert_true(_after(400, 0.001, false).is_dead())


func test_a_head_that_moves_is_alive() -> void:
	assert_false(_after(400, 0.001, true).is_dead())


func test_a_short_rush_is_forgiven() -> void:
	assert_false(_after(50, 0.001, false).is_dead(), "50 ms")
	var watch := _after(140, 0.001, false)
	watch.see_frame(200000000, STILL, RATE)
	watch.see_frame(200001000, STILL, RATE)
	assert_false(watch.is_dead(), "one in time begins anew")


func test_what_the_engine_prints_counts() -> void:
	var errors := RuntimeErrors.new()
	errors._log_error("f", "a.cpp", 1, "OpenXR: Failed to poll events!", "", false, 0, [])
	assert_true(errors.has_seen_loss())
	errors = RuntimeErrors.new()
	errors._log_error("f", "a.cpp", 1, "Something else", "", false, 0, [])
	assert_false(errors.has_seen_loss())


func test_the_simulated_headset_speaks_the_drivers_language() -> void:
	var headset := SimulatedHeadset.new()
	headset.head.origin = Vector3(1.0, 2.0, 3.0)
	headset.right.stick = Vector2(0.25, -0.5)
	headset.left.active = false
	var bytes := headset.to_bytes()
	assert_eq(bytes.size(), 376)
	assert_eq(bytes.slice(0, 8).get_string_from_ascii(), "mndrmt3")
	assert_eq(bytes.decode_float(SimulatedHeadset.HEAD_AT + 12), 1.0, "quaternion w")
	assert_eq(bytes.decode_float(SimulatedHeadset.HEAD_AT + 16), 1.0, "x")
	var right := SimulatedHeadset.HANDS_AT + SimulatedHand.BYTES
	assert_eq(bytes.decode_float(right + 84), 0.25, "stick")
	assert_eq(bytes[SimulatedHeadset.HANDS_AT + 105], 0, "left hand lost")
	assert_eq(bytes[right + 105], 1, "right hand there")


func _after(frames: int, seconds: float, moving: bool) -> RuntimeWatch:
	var watch := RuntimeWatch.new()
	for i in frames:
		var pose := STILL.translated(Vector3.RIGHT * 1e-4 * i) if moving else STILL
		watch.see_frame(1000 + roundi(i * seconds * 1e6), pose, RATE)
	return watch
