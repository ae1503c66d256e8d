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
	var pictures := await take_pictures()
	return pictures[0].get_size() if not pictures.is_empty() else Vector2i.ZERO
