# SPDX-License-Identifier: MIT
extends XrTestCase
## Those who stand around see what the visitor's eyes see, from the eyes' own places.

const SCENE: PackedScene = preload("res://scenes/xr/spectator/spectator.tscn")


func test_cameras_are_where_the_eyes_are() -> void:
	if not await begun():
		return
	var spectator: Spectator = SCENE.instantiate()
	spectator.head = visit.scene.head
	spectator.session = visit.scene.session
	spectator.sky = visit.scene.sky
	spectator.mode = Spectator.Mode.BOTH_EYES
	spectator.pictures_per_second = 0.0
	visit.add_child(spectator)
	var pose := Transform3D(Basis(Vector3(1, 2, 3).normalized(), 0.6), Vector3(0.2, 1.5, 0.3))
	assert_true(await visit.move_head(pose), "head moved")
	await wait_process_frames(3)
	assert_true(spectator.visible)
	var eyes: Array[EyeView] = []
	for view in 2:
		eyes.append(EyeView.new(visit.scene, view, Vector2i(320, 240)))
		var side := "Left" if view == 0 else "Right"
		var camera: Camera3D = spectator.get_node("%" + side + "Camera")
		assert_almost_eq(camera.global_position, eyes[view].place, Vector3.ONE * 1e-3)
		assert_lt(camera.global_basis.z.angle_to(pose.basis.z), 0.01, "looks there")
	assert_almost_eq(eyes[0].place.distance_to(eyes[1].place), 0.063, 1e-3)
	spectator.mode = Spectator.Mode.VIEW
	await visit.settle(
		func() -> bool: return spectator.get_view().origin.distance_to(pose.origin) < 1e-3
	)
	assert_almost_eq(spectator.get_view().origin, pose.origin, Vector3.ONE * 2e-3)
	assert_almost_eq(spectator.get_view().basis.x.y, 0.0, 1e-3, "level")
	spectator.free()
