# SPDX-License-Identifier: MIT
extends XrTestCase
## The menu on a real runtime: both eyes see it where it stands, and a hand's trigger chooses.


# The scene's own menu, of two lines, before the visitor.
func _set_up() -> void:
	visit.scene.sky.visible = false
	var items: Array[MenuItem] = [
		MenuItem.action(&"one", "One", Callable()), MenuItem.action(&"two", "Two", Callable())
	]
	visit.scene.menu.set_pages({&"first": MenuPage.of("Menu", items)}, &"first")
	visit.scene.menu.open(visit.scene.head.global_transform)
	await wait_process_frames(3)


func _place_of(row: MenuRow, share: Vector2 = Vector2(0.5, 0.5)) -> Vector3:
	var rect := row.get_global_rect()
	var at := (rect.position + rect.size * share) / Vector2(visit.scene.menu.surface.pixels)
	var flat := (at - Vector2.ONE * 0.5) * visit.scene.menu.surface.picture.get_extent()
	return visit.scene.menu.surface.to_global(Vector3(flat.x, -flat.y, 0.0))


func _aim_at(place: Vector3) -> void:
	var from := Vector3(0.25, 1.3, -0.2)
	var origin := visit.scene.head.get_parent() as Node3D
	var pose := Transform3D(Basis.IDENTITY, from)
	visit.headset.right.pose = pose.looking_at(origin.to_local(place))
	visit.headset.send()


func test_a_hand_chooses_and_both_eyes_see_it() -> void:
	if not await begun():
		return
	assert_true(await visit.move_head(Transform3D(Basis.IDENTITY, Vector3(0.0, 1.6, 0.3))))
	await _set_up()
	var row := visit.scene.menu.sheet.get_rows()[2]
	_aim_at(_place_of(row))
	assert_true(await visit.settle(func() -> bool: return row.lit), "pointed at")
	var pictures := await take_pictures()
	for view in pictures.size():
		var eye := EyeView.new(visit.scene, view, pictures[view].get_size())
		# Beside its words and what is at its right.
		for share: Vector2 in [Vector2(0.35, 0.2), Vector2(0.85, 0.8)]:
			var pixel := eye.to_pixel(_place_of(row, share) - eye.place)
			var lit := pictures[view].get_pixelv(Vector2i(pixel)).linear_to_srgb()
			var off := Vector3(lit.r, lit.g, lit.b) - Vector3(1.0, 0.78, 0.42)
			assert_lt(off.length(), 0.1, "eye %d at %s: %s" % [view, pixel, lit])
	watch_signals(visit.scene.menu)
	visit.headset.right.trigger = 1.0
	visit.headset.send()
	assert_true(
		await visit.settle(
			func() -> bool: return get_signal_emit_count(visit.scene.menu, "chosen") > 0
		)
	)
	assert_eq(get_signal_parameters(visit.scene.menu, "chosen"), [&"two"])
	visit.headset.right.trigger = 0.0
	visit.headset.send()
	assert_true(await visit.settle(func() -> bool: return not visit.scene.right_hand.is_choosing()))
	assert_signal_emit_count(visit.scene.menu, "chosen", 1)


func test_a_gaze_starts_a_ride_pauses_it_and_ends_it() -> void:
	if not await begun():
		return
	var scene := visit.scene
	scene.sky.visible = false
	visit.headset.left.active = false
	visit.headset.right.active = false
	assert_true(await visit.move_head(Transform3D(Basis.IDENTITY, Vector3(0.0, 1.6, 0.3))))
	scene.recentre()
	var before := scene.rig.get_radius()
	scene.menu.open(scene.head.global_transform)
	await _look_at_row(2)  # Rides, after the row that closes and Move
	assert_true(await _shows(VisitPages.RIDES), "the page of rides")
	scene.rides.countdown_seconds = 1
	await _look_at_row(1)  # Fall in, after the row that leads back
	assert_true(await visit.settle(scene.rides.is_on), "chosen")
	assert_false(scene.menu.is_open(), "and out of sight")
	assert_true(await visit.settle(func() -> bool: return scene.rides.ride != null), "under way")
	assert_almost_eq(scene.rig.get_radius(), scene.rides.fall_from, 0.3)
	scene.rides.set_paused(true)
	var paused := scene.rig.get_radius()
	await wait_seconds(0.5)
	assert_almost_eq(scene.rig.get_radius(), paused, 1e-3, "paused")
	scene.menu.open(scene.head.global_transform)
	await _look_at_row(2)
	assert_true(await _shows(VisitPages.RIDES))
	await _look_at_row(5)
	assert_true(await visit.settle(func() -> bool: return not scene.rides.is_on()), "ended")
	assert_almost_eq(scene.rig.get_radius(), before, 0.05, "back in the room")


func test_the_menus_button_opens_and_closes_it() -> void:
	if not await begun():
		return
	visit.scene.sky.visible = false
	var menu := visit.scene.menu
	for open: bool in [true, false]:
		visit.headset.left.button_b = true
		visit.headset.send()
		assert_true(await visit.settle(func() -> bool: return menu.is_open() == open))
		visit.headset.left.button_b = false
		visit.headset.send()
		await wait_process_frames(8)
		assert_eq(menu.is_open(), open)


# Looks at the row of this number until something comes of it.
func _look_at_row(number: int) -> void:
	await wait_process_frames(4)
	var room := visit.scene.rig.get_room().affine_inverse()
	var row := visit.scene.menu.sheet.get_rows()[number]
	var eyes := visit.headset.head.origin
	var place := room * _place_of(row)
	await visit.move_head(Transform3D(Basis.looking_at(place - eyes), eyes))


func _shows(page: StringName) -> bool:
	var menu := visit.scene.menu
	return await visit.settle(func() -> bool: return menu.get_page() == page)
