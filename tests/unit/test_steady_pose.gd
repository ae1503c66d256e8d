# SPDX-License-Identifier: MIT
extends GutTest
## The spectators' view neither trembles nor rolls, and comes to where the head is.

const FRAME: float = 1.0 / 72.0


func test_trembling_is_taken_out() -> void:
	var steady := SteadyPose.new()
	steady.settle(Vector3.ZERO, Basis.IDENTITY, Vector3.UP)
	var widest := 0.0
	var largest := 0.0
	for i in 400:
		var phase := sin(TAU * 5.0 * i * FRAME)
		var view := Basis(Vector3.UP, deg_to_rad(phase)) * Basis(Vector3.RIGHT, deg_to_rad(phase))
		steady.follow(Vector3.RIGHT * 0.01 * phase, view, Vector3.UP, FRAME)
		widest = maxf(widest, steady.get_place().length())
		largest = maxf(largest, Basis.IDENTITY.z.angle_to(steady.get_basis().z))
	assert_between(widest, 1e-6, 0.2 * 0.01, "of a centimetre")
	assert_between(rad_to_deg(largest), 1e-4, 0.2, "of a degree")


func test_it_gets_there_whatever_the_frames() -> void:
	var place := Vector3(1.0, 2.0, -3.0)
	var view := Basis(Vector3.UP, 1.2)
	var halfway: PackedFloat64Array = []
	for frame: float in [0.004, 0.02]:
		var steady := SteadyPose.new()
		steady.settle(Vector3.ZERO, Basis.IDENTITY, Vector3.UP)
		for i in roundi(0.4 / frame):
			steady.follow(place, view, Vector3.UP, frame)
		halfway.append(steady.get_place().length() / place.length())
		for i in roundi(4.0 / frame):
			steady.follow(place, view, Vector3.UP, frame)
		assert_almost_eq(steady.get_place(), place, Vector3.ONE * 1e-3)
		assert_lt(steady.get_basis().z.angle_to(view.z), 1e-3)
	assert_between(halfway[0], 0.4, 0.8)
	assert_almost_eq(halfway[0], halfway[1], 0.03)


func test_roll_is_taken_out_where_there_is_a_horizon() -> void:
	for up: Vector3 in [Vector3.UP, Vector3(1.0, 2.0, 0.5).normalized()]:
		var rig := Basis(Quaternion(Vector3.UP, up))
		for pitch: float in [-0.9, 0.0, 0.7]:
			var view := rig * Basis(Vector3.UP, 0.8) * Basis(Vector3.RIGHT, pitch)
			var rolled := SteadyPose.levelled(view * Basis(Vector3.BACK, 0.6), up)
			assert_lt(rolled.z.angle_to(view.z), 1e-4, "looks there")
			assert_almost_eq(rolled.x.dot(up), 0.0, 1e-4, "level")


func test_straight_up_the_head_says_where_up_is() -> void:
	var view := Basis(Vector3.UP, 0.3) * Basis(Vector3.RIGHT, 0.5 * PI)
	assert_lt(SteadyPose.levelled(view, Vector3.UP).y.angle_to(view.y), 1e-3)
	# On the way there nothing jumps.
	var last := SteadyPose.levelled(Basis.IDENTITY, Vector3.UP)
	var largest := 0.0
	for i in range(1, 315):
		var pitch := 0.005 * i
		var rolled := Basis(Vector3.RIGHT, pitch) * Basis(Vector3.BACK, 0.3)
		var next := SteadyPose.levelled(rolled, Vector3.UP)
		if i > 1:
			largest = maxf(largest, last.y.angle_to(next.y))
		last = next
	assert_lt(largest, 0.05)
