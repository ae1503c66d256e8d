# SPDX-License-Identifier: MIT
extends RigCase
## Rides in the headset take the visitor along the exact way, can be paused and left at any time,
## and bring everything back as it was.

var _rides: XrRides


func before_each() -> void:
	super()
	comfort.blinks = false
	_rides = XrRides.new()
	_rides.rig = rig
	_rides.sky = sky
	put(_rides)
	watch_signals(_rides)


func test_a_countdown_leads_to_the_ride() -> void:
	_rides.start(XrRides.Kind.FALL)
	assert_eq(_rides.state, XrRides.State.COUNTDOWN)
	_elapse(1.5)
	assert_signal_emit_count(_rides, "counted_down", 2)
	assert_eq(_rides.state, XrRides.State.COUNTDOWN)
	_elapse(2.0)
	assert_eq(_rides.state, XrRides.State.RIDING)
	assert_signal_emit_count(_rides, "began", 1)


func test_a_countdown_can_be_left() -> void:
	_rides.start(XrRides.Kind.FALL)
	_elapse(1.0)
	var before := rig.get_room()
	_rides.leave()
	_elapse(5.0)
	assert_false(_rides.is_on())
	assert_eq(rig.get_room(), before)
	assert_signal_emitted_with_parameters(_rides, "ended", [false])


func test_a_fall_goes_along_the_exact_way() -> void:
	_begin(XrRides.Kind.FALL)
	assert_almost_eq(rig.get_radius(), _rides.fall_from, 1e-3, "starts there")
	_elapse(10.0)
	var exact := RadialFallPath.new()
	exact.start_from_rest(_rides.fall_from + XrRides.LEANING)
	var radius := exact.radius_at(_rides.ride.get_proper_time())
	assert_almost_eq(rig.get_radius() / radius, 1.0, 1e-4)
	assert_almost_eq(rig.get_place().normalized(), Vector3.BACK, Vector3.ONE * 1e-3, "and straight")
	assert_eq(sky.observer.motion, LensingTable.MOTION_INFALL, "as one who falls")
	assert_eq(rig.get_yaw(), 0.0, "without being turned")


func test_the_head_moves_freely_on_a_ride() -> void:
	_begin(XrRides.Kind.FALL)
	var before := rig.get_place()
	_rides.set_paused(true)
	head.position += Vector3(0.2, -0.1, 0.0)
	_elapse(0.2)
	assert_almost_eq(rig.get_place() - before, Vector3(0.2, -0.1, 0.0), Vector3.ONE * 1e-4)


func test_a_pause_stops_it() -> void:
	_begin(XrRides.Kind.FALL)
	_elapse(2.0)
	_rides.set_paused(true)
	var before := rig.get_radius()
	_elapse(3.0)
	assert_almost_eq(rig.get_radius(), before, 1e-6)
	_rides.set_paused(false)
	_elapse(1.0)
	assert_lt(rig.get_radius(), before)
	assert_signal_emit_count(_rides, "pause_changed", 2)


func test_all_is_as_before_after_leaving() -> void:
	var room := rig.get_room()
	var curtain := Curtain.new()
	put(curtain)
	_rides.curtain = curtain
	_begin(XrRides.Kind.FALL)
	_elapse(4.0)
	assert_almost_eq(_rides.get_home_radius(), 0.5, 1e-6)
	assert_eq(_rides.get_home(), room)
	_rides.leave()
	assert_false(_rides.is_on())
	assert_eq(rig.get_room(), room)
	assert_almost_eq(sky.schwarzschild_radius, 0.5, 1e-6)
	assert_null(sky.observer)
	assert_eq(curtain.get_darkness(), 0.0)


func test_a_fall_ends_in_the_dark_and_comes_back() -> void:
	var curtain := Curtain.new()
	put(curtain)
	_rides.curtain = curtain
	_begin(XrRides.Kind.FALL)
	var darkest := 0.0
	for i in 4000:
		if not _rides.is_on():
			break
		darkest = maxf(darkest, curtain.get_darkness())
		_rides.advance(0.05)
	assert_false(_rides.is_on())
	assert_gt(darkest, 0.9)
	assert_signal_emitted_with_parameters(_rides, "ended", [true])
	assert_almost_eq(rig.get_radius(), 5.0, 1e-3)


func test_an_orbit_goes_round_with_the_hole_ahead(
	sense: float = use_parameters([1.0, -1.0])
) -> void:
	_begin(XrRides.Kind.ORBIT_RIGHT if sense > 0.0 else XrRides.Kind.ORBIT_LEFT)
	_rides.set_paused(true)
	assert_almost_eq(rig.get_radius(), 5.0, 1e-3)
	var place := rig.get_place()
	var seen := _hole_seen()
	_rides.set_paused(false)
	_elapse(6.0)
	assert_almost_eq(rig.get_radius(), 5.0, 1e-3, "at the same distance")
	var turn := sense * place.cross(rig.get_place()).y
	assert_gt(turn, 0.2 * place.length_squared(), "round the hole")
	assert_almost_eq(_hole_seen(), seen, Vector3.ONE * 2e-3, "which stays where it was")
	assert_almost_eq(seen, Vector3.FORWARD, Vector3.ONE * 2e-3, "ahead, by sight")


func test_orbits_that_are_too_near_are_taken_farther_out() -> void:
	rig.jump_to(Vector3(0.0, 0.0, 1.0))  # r = 2
	_begin(XrRides.Kind.ORBIT_RIGHT)
	assert_almost_eq(rig.get_radius(), _rides.least_orbit, 1e-3)


func test_the_place_is_kept_for_a_new_start() -> void:
	var scratch := ScratchFolder.new("place")
	var file := scratch.file("place.json")
	rig.jump_to(Vector3(1.0, 0.2, 2.0))
	VisitMemory.store(0.5, sky.global_position, rig.get_room(), file)
	var other: BlackHoleSky = autofree(BlackHoleSky.new())
	add_child(other)
	var room: Variant = VisitMemory.recall(other, file)
	assert_eq(room, rig.get_room())
	assert_almost_eq(other.schwarzschild_radius, 0.5, 1e-6)
	assert_eq(other.global_position, sky.global_position)
	assert_null(VisitMemory.recall(other, file), "and forgotten")
	FileAccess.open(file, FileAccess.WRITE).store_string(
		'{"radius": -3.0, "hole": [0, 0, 0], "room": 5}'
	)
	assert_null(VisitMemory.recall(other, file), "damaged")


func _begin(kind: XrRides.Kind) -> void:
	_rides.countdown_seconds = 0
	_rides.start(kind)
	_rides.advance(0.001)
	assert_eq(_rides.state, XrRides.State.RIDING)


func _elapse(seconds: float) -> void:
	for i in roundi(seconds * 50.0):
		_rides.advance(0.02)


# Where the middle of the hole is seen, as the head has it.
func _hole_seen() -> Vector3:
	var place := rig.get_place() / sky.schwarzschild_radius
	var seen: Vector3 = sky.observer.shadow(place)["direction"]
	return head.global_basis.inverse() * seen
