# SPDX-License-Identifier: MIT
extends XrTestCase
## What the quality ladder sets reaches the headset: each eye's picture is drawn with fewer pixels.


func test_eyes_are_drawn_with_fewer_pixels() -> void:
	if not await begun():
		return
	var whole := await _size_of_pictures(1.0)
	var part := await _size_of_pictures(0.75)
	gut.p(
		(
			"%s, at 0.75 %s; %.1f Hz"
			% [whole, part, visit.scene.session.get_interface().display_refresh_rate]
		)
	)
	assert_gt(whole.x, 0)
	assert_almost_eq(Vector2(part), 0.75 * Vector2(whole), Vector2.ONE * 1.5)


func _size_of_pictures(scale: float) -> Vector2i:
	visit.scene.session.viewport.scaling_3d_scale = scale
	var compositor := Compositor.new()
	var capture := EyeCapture.new()
	compositor.compositor_effects = [capture]
	visit.scene.head.compositor = compositor
	await wait_process_frames(4)
	watch_signals(capture)
	capture.request()
	await wait_for_signal(capture.taken, 10.0)
	visit.scene.head.compositor = null
	var emitted: Array = get_signal_parameters(capture, "taken")
	if emitted == null or emitted.is_empty():
		return Vector2i.ZERO
	var pictures: Array[Image] = emitted[0]
	return pictures[0].get_size()
