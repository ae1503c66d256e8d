# SPDX-License-Identifier: MIT
extends XrTestCase
## The session on a real runtime: it comes into focus, the camera is where the head is, the hole in
## front.


func test_the_session_comes_into_focus() -> void:
	if not await begun():
		return
	assert_true(visit.scene.session.viewport.use_xr)
	assert_eq(DisplayServer.window_get_vsync_mode(), DisplayServer.VSYNC_DISABLED)
	assert_gt(visit.scene.session.get_interface().get_view_count(), 1)


func test_the_camera_is_where_the_head_is() -> void:
	if not await begun():
		return
	for pose: Transform3D in [
		Transform3D(Basis(Vector3.UP, 0.7), Vector3(0.3, 1.5, -0.2)),
		Transform3D(Basis(Vector3(1, 2, 3).normalized(), 1.1), Vector3(-0.6, 1.2, 0.4)),
	]:
		assert_true(await visit.move_head(pose), "the head is at %s" % pose)
		await wait_process_frames(2)
		var camera := visit.scene.head
		assert_almost_eq(camera.global_position, pose.origin, Vector3.ONE * 1e-3)
		assert_true(camera.global_basis.is_equal_approx(pose.basis), "and looks there")


func test_the_hole_stands_before_the_visitor() -> void:
	if not await begun():
		return
	var scene := visit.scene
	assert_true(await visit.settle(func() -> bool: return scene.sky.schwarzschild_radius > 0.0))
	var to_hole := scene.sky.global_position - scene.head.global_position
	assert_almost_eq(to_hole.length() / scene.sky.schwarzschild_radius, HoleInRoom.WALK_RADII, 0.2)
	assert_gt((-scene.head.global_basis.z).dot(to_hole.normalized()), 0.9, "ahead")


func test_who_walks_too_near_is_told_why_it_goes_dark() -> void:
	if not await begun():
		return
	var scene := visit.scene
	scene.sky.visible = false
	var words: VisitSign = scene.get_node(^"Headset/Origin/Sign")
	assert_true(await visit.settle(scene.has_started))
	var away := scene.head.global_position
	var near := scene.sky.global_position + (away - scene.sky.global_position) * 0.3  # r = 1.5
	assert_true(await visit.move_head(Transform3D(Basis.IDENTITY, near)))
	assert_true(await visit.settle(func() -> bool: return words.visible), "told")
	assert_string_contains(words.get_words(), "Step back")
	var curtain: Curtain = scene.head.get_node(^"Curtain")
	assert_gt(curtain.get_darkness(), 0.5, "dark")
	assert_gt(
		words.material_override.render_priority,
		curtain.material_override.render_priority,
		"legible"
	)
	assert_true(await visit.move_head(Transform3D(Basis.IDENTITY, away)))
	assert_true(await visit.settle(func() -> bool: return not words.visible), "and no longer")
	assert_eq(curtain.get_darkness(), 0.0)
