# SPDX-License-Identifier: MIT
extends RigCase
## Turning and flying move the visitor exactly as they say.


func test_turning_goes_about_the_head() -> void:
	var before := head.global_position
	rig.snap(0.5)
	assert_almost_eq(head.global_position, before, Vector3.ONE * 1e-5, "it stays in its place")
	assert_almost_eq(rig.get_yaw(), 0.5, 1e-5, "and looks to the left")


func test_a_push_of_the_stick_turns_by_one_step() -> void:
	var turn := SnapTurn.new()
	turn.rig = rig
	turn.hands = hands()
	put(turn)
	right.stick = Vector2(1.0, 0.0)
	for i in 5:
		turn._process(0.02)
	assert_almost_eq(rig.get_yaw(), -deg_to_rad(30.0), 1e-5, "once, to the right")
	right.stick = Vector2.ZERO
	turn._process(0.02)
	left.stick = Vector2(-0.8, 0.1)
	turn._process(0.02)
	assert_almost_eq(rig.get_yaw(), 0.0, 1e-5, "the other hand turns as well")
	left.stick = Vector2(0.5, 0.0)
	turn._process(0.02)
	assert_almost_eq(rig.get_yaw(), 0.0, 1e-5, "half a push after a whole one is none")


func test_a_hand_that_does_not_count_turns_nothing() -> void:
	var turn := SnapTurn.new()
	turn.rig = rig
	turn.hands = hands()
	put(turn)
	comfort.hands = Comfort.Hands.RIGHT
	left.stick = Vector2(1.0, 0.0)
	turn._process(0.02)
	assert_almost_eq(rig.get_yaw(), 0.0, 1e-6)
	right.stick = Vector2(1.0, 0.0)
	turn._process(0.02)
	assert_almost_eq(rig.get_yaw(), -deg_to_rad(30.0), 1e-5)


func test_gliding_turns_as_fast_as_it_says() -> void:
	var turn := SmoothTurn.new()
	turn.rig = rig
	turn.hands = hands()
	turn.enabled = true
	put(turn)
	right.stick = Vector2(-0.5, 0.0)
	_advance(turn, 1.0)  # up to speed
	var before := rig.get_yaw()
	_advance(turn, 0.5)
	assert_almost_eq(rig.get_yaw() - before, deg_to_rad(15.0), 1e-4)


func test_flight_goes_where_the_hand_points_in_proportion_to_the_distance() -> void:
	var flight := _flight()
	right.stick = Vector2(0.0, -1.0)  # backwards, away from the hole
	right.grip = 1.0
	_advance(flight, 1.0)
	var before := rig.get_radius()
	_advance(flight, 0.5)
	assert_almost_eq(log(rig.get_radius() / before), 0.5 / flight.seconds_per_e, 0.01)
	assert_almost_eq(rig.get_place().normalized(), Vector3.BACK, Vector3.ONE * 1e-4)


func test_an_open_hand_flies_slower() -> void:
	var flight := _flight()
	assert_almost_eq(flight.speed(1.0, 0.0), flight.open_hand / flight.seconds_per_e, 1e-6)
	assert_almost_eq(flight.speed(-0.5, 1.0), -0.5 / flight.seconds_per_e, 1e-6)


func test_flight_ends_at_its_limits() -> void:
	var flight := _flight()
	right.grip = 1.0
	right.stick = Vector2(0.0, 1.0)
	_advance(flight, 10.0)
	assert_almost_eq(rig.get_radius(), flight.nearest, 1e-3)
	right.stick = Vector2(0.0, -1.0)
	_advance(flight, 20.0)
	assert_almost_eq(rig.get_radius(), flight.farthest, 1e-2)


func test_who_walked_too_near_can_fly_away_again() -> void:
	var flight := _flight()
	rig.jump_to(Vector3(0.0, 0.0, 1.2 * sky.schwarzschild_radius))
	right.stick = Vector2(0.0, 1.0)
	_advance(flight, 1.0)
	assert_almost_eq(rig.get_radius(), 1.2, 1e-3, "no nearer")
	right.stick = Vector2(0.0, -1.0)
	_advance(flight, 1.0)
	assert_gt(rig.get_radius(), 1.25, "but away")


func test_being_moved_is_felt_and_jumps_are_not() -> void:
	rig._process(0.02)
	rig.jump_to(Vector3(0.0, 0.0, 3.0))
	rig._process(0.02)
	assert_eq(rig.get_motion(), 0.0, "a jump")
	rig.turn(0.02)
	rig._process(0.02)
	assert_eq(rig.get_motion(), 1.0, "a fast turn")
	for i in 100:
		rig._process(0.02)
	assert_lt(rig.get_motion(), 0.01, "ends")


func test_a_blink_hides_the_jump() -> void:
	rig.curtain = Curtain.new()
	put(rig.curtain)
	var seen := {"darkness": -1.0}
	rig.blink(func() -> void: seen["darkness"] = rig.curtain.get_darkness())
	assert_true(rig.is_blinking())
	await wait_until(func() -> bool: return not rig.is_blinking(), 2.0)
	assert_almost_eq(float(seen["darkness"]), 1.0, 1e-3)
	assert_eq(rig.curtain.get_darkness(), 0.0, "and opens again")


func test_the_field_of_view_closes_in_and_opens() -> void:
	var vignette: Vignette = autofree(Vignette.new())
	vignette.follow(0.7, 1.0)
	assert_almost_eq(vignette.get_closing(), 0.7, 0.01)
	assert_true(vignette.visible)
	for i in 10:
		vignette.follow(0.0, 1.0)
	assert_false(vignette.visible)


func test_presets() -> void:
	comfort.preset = Comfort.Preset.FREE
	assert_true(comfort.smooth_turn)
	assert_eq(comfort.vignette, 0.0)
	comfort.preset = Comfort.Preset.COMFORT
	assert_false(comfort.smooth_turn)
	assert_gt(comfort.vignette, 0.0)
	assert_true(comfort.fixed_frame)


func _flight() -> Flight:
	var flight := Flight.new()
	flight.rig = rig
	flight.hands = hands()
	flight.enabled = true
	put(flight)
	return flight


func _advance(what: Node, seconds: float) -> void:
	var steps := roundi(seconds * 50.0)
	for i in steps:
		what.call(&"advance", seconds / steps)
