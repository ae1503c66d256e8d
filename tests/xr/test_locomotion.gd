# SPDX-License-Identifier: MIT
extends XrTestCase
## Each way to move, by stick, trigger and gaze of a real runtime's hands and head, moves the
## visitor exactly as it says.

const HEAD := Vector3(0.0, 1.6, 0.0)


func test_the_stick_turns_in_steps() -> void:
	if not await _stands():
		return
	var rig := visit.scene.rig
	var place := rig.get_place()
	var yaw := rig.get_yaw()
	await _push(visit.headset.right, Vector2(1.0, 0.0))
	assert_true(await _turns_to(yaw - deg_to_rad(30.0)), "a step to the right")
	await wait_process_frames(5)
	assert_almost_eq(angle_difference(yaw, rig.get_yaw()), -deg_to_rad(30.0), 1e-3, "and one only")
	await _push(visit.headset.right, Vector2.ZERO)
	await _push(visit.headset.left, Vector2(-1.0, 0.0))
	assert_true(await _turns_to(yaw), "the other hand turns back")
	assert_almost_eq(rig.get_place(), place, Vector3.ONE * 1e-3, "the head stays in its place")
	await _push(visit.headset.left, Vector2.ZERO)


func test_one_hand_alone_counts_when_asked_for() -> void:
	if not await _stands():
		return
	var scene := visit.scene
	scene.comfort.hands = Comfort.Hands.LEFT
	var yaw := scene.rig.get_yaw()
	await _push(visit.headset.right, Vector2(1.0, 0.0))
	await wait_process_frames(10)
	assert_almost_eq(scene.rig.get_yaw(), yaw, 1e-3, "the right hand is idle")
	await _push(visit.headset.right, Vector2.ZERO)
	await _push(visit.headset.left, Vector2(1.0, 0.0))
	assert_true(await _turns_to(yaw - deg_to_rad(30.0)), "the left one does it all")
	await _push(visit.headset.left, Vector2.ZERO)


func test_the_stick_flies_where_the_hand_points_and_the_grip_is_the_throttle() -> void:
	if not await _stands():
		return
	var scene := visit.scene
	scene.comfort.preset = Comfort.Preset.FREE
	# Away from the hole, which is ahead: backwards on a level beam.
	var hand := visit.headset.right
	var slow := await _flown(hand, 0.0)
	var fast := await _flown(hand, 1.0)
	var flight := scene.flight
	var wanted := flight.speed(1.0, 0.0)
	gut.p("speeds %.3f and %.3f e-foldings a second" % [slow, fast])
	assert_almost_eq(slow / wanted, 1.0, 0.02, "open hand")
	assert_almost_eq(fast / flight.speed(1.0, 1.0), 1.0, 0.02, "closed hand")


func test_a_trigger_jumps_to_the_ring_that_is_pointed_at() -> void:
	if not await _stands():
		return
	var scene := visit.scene
	scene.rings_shown = true
	# The far side of the ring at r = 4, above the hole as seen from here.
	var target := _ring_point(4.0, PI)
	_point(visit.headset.right, target)
	visit.headset.send()
	assert_true(
		await visit.settle(func() -> bool: return scene.jump.get_ring() == 4.0), "pointed at"
	)
	visit.headset.right.trigger = 1.0
	visit.headset.send()
	await _arrives(4.0)
	visit.headset.right.trigger = 0.0
	visit.headset.send()


func test_a_gaze_jumps_after_a_while() -> void:
	if not await _stands():
		return
	var scene := visit.scene
	scene.rings_shown = true
	_switch_off_hands()
	var target := _ring_point(3.0, 0.3)
	var gaze := scene.rig.get_room().affine_inverse() * target
	var looking := Transform3D(Basis.looking_at(gaze - HEAD), HEAD)
	assert_true(await visit.move_head(looking), "looks there")
	assert_true(await visit.settle(func() -> bool: return scene.jump.get_ring() == 3.0), "gazed at")
	var before := Time.get_ticks_msec()
	await _arrives(3.0)
	assert_gt(Time.get_ticks_msec() - before, roundi(800.0 * scene.jump.dwell), "not at once")


func test_recentring_puts_the_hole_ahead_again() -> void:
	if not await _stands():
		return
	var scene := visit.scene
	var turned := Transform3D(Basis(Vector3.UP, 2.0), Vector3(0.5, 1.2, -0.3))
	assert_true(await visit.move_head(turned))
	scene.recentre()
	await wait_process_frames(3)
	var to_hole := (scene.sky.global_position - scene.head.global_position).normalized()
	var ahead := -scene.head.global_basis.z
	assert_gt(ahead.dot(to_hole), cos(HoleInRoom.DIP) - 0.02, "ahead and a little lower")
	assert_almost_eq(scene.rig.get_radius(), HoleInRoom.WALK_RADII, 0.05)


func test_a_hand_that_is_lost_does_nothing_and_comes_back() -> void:
	if not await _stands():
		return
	var scene := visit.scene
	var hand := scene.right_hand
	assert_true(await visit.settle(hand.is_here), "there at first")
	await wait_process_frames(2)
	watch_signals(hand)
	visit.headset.right.active = false
	visit.headset.right.stick = Vector2(1.0, 0.0)
	visit.headset.send()
	var yaw := scene.rig.get_yaw()
	assert_true(await visit.settle(func() -> bool: return not hand.is_here()), "lost")
	await wait_process_frames(10)
	assert_almost_eq(scene.rig.get_yaw(), yaw, 1e-3, "turns nothing")
	visit.headset.right.active = true
	visit.headset.send()
	assert_true(await visit.settle(hand.is_here), "back")
	assert_true(await _turns_to(yaw - deg_to_rad(30.0)), "and turns")
	assert_signal_emit_count(hand, "presence_changed", 2)


# In focus, head upright, hole ahead, hands here.
func _stands() -> bool:
	if not await begun():
		return false
	if not await visit.move_head(Transform3D(Basis.IDENTITY, HEAD)):
		fail_test("the head did not move")
		return false
	var scene := visit.scene
	scene.recentre()
	# Not looked at here; frames come faster without.
	scene.sky.visible = false
	return await visit.settle(
		func() -> bool: return scene.right_hand.is_here() and scene.left_hand.is_here()
	)


func _push(hand: SimulatedHand, stick: Vector2) -> void:
	hand.stick = stick
	visit.headset.send()
	var side := visit.scene.left_hand if hand == visit.headset.left else visit.scene.right_hand
	await visit.settle(func() -> bool: return side.get_vector2(&"steer").is_equal_approx(stick))
	await wait_process_frames(2)


func _turns_to(yaw: float) -> bool:
	var rig := visit.scene.rig
	return await visit.settle(
		func() -> bool: return absf(angle_difference(rig.get_yaw(), yaw)) < 1e-3, 5.0
	)


# How fast the distance's logarithm grows while the stick is drawn back.
func _flown(hand: SimulatedHand, grip: float) -> float:
	var rig := visit.scene.rig
	visit.scene.recentre()
	hand.grip = grip
	hand.pose = Transform3D(Basis.looking_at(-rig.get_place()), Vector3(0.2, 1.3, -0.4))
	await _push(hand, Vector2(0.0, -1.0))
	await wait_seconds(0.8)
	# In the time that the engine tells of its frames: the machine may be busy.
	await get_tree().process_frame
	var from := log(rig.get_radius())
	var seconds := 0.0
	while seconds < 0.8:
		# The nodes move by it after this signal.
		seconds += minf(get_process_delta_time(), 0.1)
		await get_tree().process_frame
	var rate := (log(rig.get_radius()) - from) / seconds
	hand.grip = 0.0
	await _push(hand, Vector2.ZERO)
	await wait_seconds(0.8)
	return rate


# Where one looks to see the ring's point in this direction (radians from the visitor's side).
func _ring_point(radius: float, azimuth: float) -> Vector3:
	var scene := visit.scene
	var eye := scene.head.global_position
	var to_eye := scene.rig.get_place() * Vector3(1.0, 0.0, 1.0)
	var wanted := to_eye.normalized().rotated(Vector3.UP, azimuth)
	var best := Vector3.ZERO
	var least := INF
	var observer := SkyObserver.new()
	var place := scene.rig.get_place() / scene.sky.schwarzschild_radius
	for i in range(-60, 61):
		for j in range(-60, 61):
			var basis := Basis.looking_at(scene.sky.global_position - eye)
			var seen := (basis * Vector3(0.02 * i, 0.02 * j, -1.0)).normalized()
			var point := observer.disk_point(place, seen, Vector3.UP, 0, false)
			if point.get("reached", false):
				var off: float = (point["place"] * point["radius"]).distance_to(wanted * radius)
				if off < least:
					least = off
					best = seen
	assert_lt(least, 0.3, "the ring is in sight")
	var ahead := (scene.sky.global_position - eye).normalized()
	return eye + best * scene.rig.get_radius_metres() / best.dot(ahead)


func _point(hand: SimulatedHand, at: Vector3) -> void:
	var there := visit.scene.rig.get_room().affine_inverse() * at
	hand.pose = Transform3D(Basis.looking_at(there - hand.pose.origin), hand.pose.origin)


func _switch_off_hands() -> void:
	visit.headset.left.active = false
	visit.headset.right.active = false
	visit.headset.send()


func _arrives(radius: float) -> void:
	var rig := visit.scene.rig
	assert_true(
		await visit.settle(func() -> bool: return absf(rig.get_radius() - radius) < 0.02 * radius),
		"arrives at %.1f" % radius
	)
	await visit.settle(func() -> bool: return not rig.is_blinking())
	var latitude := asin(rig.get_place().normalized().y)
	assert_almost_eq(rad_to_deg(latitude), visit.scene.jump.latitude_degrees, 1.0, "latitude")
