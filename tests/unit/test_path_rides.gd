# SPDX-License-Identifier: MIT
extends GutTest
## Rides of a sequence: frames against the closed forms of the motions.

## 2.5 seconds at 20 frames a second.
const FRAMES: int = 50


func test_rain_takes_the_whole_film() -> void:
	var spec := _ride({"kind": "fall", "from_rs": 30})
	assert_eq(spec.error, "")
	assert_eq(spec.observer.motion, LensingTable.MOTION_RAIN)
	# Rain: proper time from r is (2/3) r^(3/2).
	var start := pow(30.0, 1.5)
	var end := pow(0.05, 1.5)
	for frame: int in [0, 1, 17, 48, 49]:
		spec.go_to(frame)
		var radius := pow(lerpf(start, end, frame / (FRAMES - 1.0)), 2.0 / 3.0)
		_expect(spec.position, [0.0, 0.0, radius], 1e-9)
		_expect(spec.forward, [0.0, 0.0, -1.0], 1e-12)


func test_slow_motion_is_film_per_proper_time() -> void:
	var spec := _ride({"kind": "fall", "from_rs": 4, "to_rs": 1.5, "slow_motion": 0.5})
	assert_eq(spec.error, "")
	for frame: int in [0, 10, 30]:
		spec.go_to(frame)
		# A second of film is 2 r_s/c, of which (2/3) (8 - r^(3/2)) have passed.
		var radius := pow(8.0 - 1.5 * 2.0 * frame / 20.0, 2.0 / 3.0)
		assert_almost_eq(spec.position[2], radius, 1e-9)
	# At r = 1.5 after 4.11 r_s/c, in frame 42; there it is held.
	for frame: int in [42, 49]:
		spec.go_to(frame)
		assert_almost_eq(spec.position[2], 1.5, 1e-9)


func test_a_film_may_end_before_the_fall() -> void:
	var spec := _ride({"kind": "fall", "from_rs": 4, "to_rs": 1.5, "slow_motion": 10})
	spec.go_to(FRAMES - 1)
	assert_almost_eq(spec.position[2], pow(8.0 - 1.5 * 0.245, 2.0 / 3.0), 1e-9)


func test_a_fall_from_rest_is_a_cycloid_on_the_radius_asked_for() -> void:
	var observer := {"motion": "infall", "rest_radius_rs": 8}
	var ride := {"kind": "fall", "from_rs": 8, "to_rs": 0.5}
	var keys := {"observer": observer, "position_rs": [0, -3, 4], "look_at_rs": [9, 9, 9]}
	var spec := _ride(ride, keys)
	assert_eq(spec.error, "")
	assert_almost_eq(spec.observer.energy, sqrt(7.0 / 8.0), 1e-15)
	# r = 4 (1 + cos a) at the proper time (8^(3/2)/2) (a + sin a).
	var end := acos(0.5 / 4.0 - 1.0)
	for frame: int in [0, 20, 35, 49]:
		spec.go_to(frame)
		var radius := Vec3D.length(spec.position)
		var angle := acos(radius / 4.0 - 1.0)
		var share := (angle + sin(angle)) / (end + sin(end))
		assert_almost_eq(share, frame / (FRAMES - 1.0), 1e-7)
		_expect(spec.position, [0.0, -0.6 * radius, 0.8 * radius], 1e-12)
		var aim := Vec3D.normalized(Vec3D.subtract([9.0, 9.0, 9.0], spec.position))
		_expect(spec.forward, aim, 1e-12)


func test_a_fall_with_an_energy_follows_the_exact_path() -> void:
	var observer := {"motion": "infall", "energy": 1.5}
	var spec := _ride({"kind": "fall", "from_rs": 5, "to_rs": 0.2}, {"observer": observer})
	var fall := RadialFallPath.new()
	fall.start_with_energy(5.0, 1.5)
	for frame: int in [0, 30, 49]:
		spec.go_to(frame)
		var time := fall.proper_time_to(0.2) * frame / (FRAMES - 1.0)
		assert_almost_eq(spec.position[2], fall.radius_at(time), 1e-12)
		assert_eq(spec.observer.energy, 1.5)


func test_one_frame_is_the_start() -> void:
	var path := {"fps": 1, "duration_s": 1, "ride": {"kind": "fall", "from_rs": 3}}
	var spec := ShotSpec.from_data({"path": path})
	assert_eq(spec.sequence.frame_count, 1)
	assert_almost_eq(spec.position[2], 3.0, 1e-12)


func test_an_orbit_is_one_turn_that_ends_where_it_began() -> void:
	var spec := _ride({"kind": "orbit", "from_rs": 6})
	assert_eq(spec.error, "")
	var orbit := CircularOrbitPath.new()
	orbit.start(Vector3(0, 0, 6), Vector3.UP)
	for frame: int in [0, 1, 20, 49]:
		spec.go_to(frame)
		var angle := TAU * frame / FRAMES
		# Right-handed about y: from z towards x.
		_expect(spec.position, [6.0 * sin(angle), 0.0, 6.0 * cos(angle)], 1e-12)
		var place := Vec3D.to_vector3(spec.position)
		var time := orbit.get_period() * frame / FRAMES
		assert_almost_eq(place, orbit.position_at(time), 1e-5 * Vector3.ONE)
		var celerity := spec.observer.to_sky_observer().celerity_at(place)
		assert_almost_eq(celerity, orbit.celerity_at(time), 1e-5 * Vector3.ONE)


func test_an_orbit_in_slow_motion() -> void:
	var spec := _ride({"kind": "orbit", "from_rs": 2, "slow_motion": 0.1})
	# Schwarzschild, r = 2: the proper time of a turn is 2 pi sqrt(2 r^3 (1 - 1.5/r)).
	var period := TAU * sqrt(16.0 * 0.25)
	for frame: int in [7, 49]:
		spec.go_to(frame)
		var angle := TAU * frame / 20.0 * 10.0 / period
		_expect(spec.position, [2.0 * sin(angle), 0.0, 2.0 * cos(angle)], 1e-9)


func test_orbits_in_any_plane() -> void:
	# Without a start: across the axis, as near to z as that comes.
	var spec := _ride({"kind": "orbit", "from_rs": 5, "axis": [0, 0, -2]})
	_expect(spec.position, [5.0, 0.0, 0.0], 1e-12)
	spec.go_to(10)
	assert_lt(spec.position[1], 0.0, "right-handed about -z")
	spec = _ride({"kind": "orbit", "from_rs": 5, "axis": [0, 1, 1]})
	_expect(spec.position, [0.0, -5.0 * sqrt(0.5), 5.0 * sqrt(0.5)], 1e-12)
	# With one: only the part of the axis across it counts.
	var keys := {"position_rs": [3, 0, 0], "aim": "apparent"}
	spec = _ride({"kind": "orbit", "from_rs": 5, "axis": [1, 1, 0]}, keys)
	assert_eq(spec.error, "")
	_expect(spec.position, [5.0, 0.0, 0.0], 1e-12)
	spec.go_to(31)
	assert_almost_eq(spec.position[1], 0.0, 1e-12)
	_expect(spec.observer.axis, [0.0, 1.0, 0.0], 1e-12)
	assert_almost_eq(Vec3D.length(spec.position), 5.0, 1e-12)


func _ride(ride: Dictionary, keys: Dictionary = {}) -> ShotSpec:
	var path := {"fps": 20, "duration_s": 2.5, "ride": ride}
	return ShotSpec.from_data(keys.merged({"path": path}))


func _expect(got: PackedFloat64Array, expected: PackedFloat64Array, tolerance: float) -> void:
	var off := Vec3D.length(Vec3D.subtract(got, expected))
	assert_lt(off, tolerance, "%s, not %s" % [got, expected])
