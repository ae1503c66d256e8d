# SPDX-License-Identifier: MIT
extends GutTest
## The hole fits the play area, stands before the visitor, and fades before one walks into it.

var _sky: BlackHoleSky
var _origin: XROrigin3D
var _hole: HoleInRoom


func before_each() -> void:
	_sky = BlackHoleSky.new()
	_origin = XROrigin3D.new()
	_hole = HoleInRoom.new()
	_hole.sky = _sky
	_hole.origin = _origin
	for node: Node in [_sky, _origin, _hole]:
		add_child_autofree(node)


func test_without_room_to_walk_it_is_small_and_ahead() -> void:
	var head := Transform3D(Basis(Vector3.UP, 0.5 * PI), Vector3(1.0, 1.2, 2.0))
	_hole.place(PackedVector3Array(), head)
	assert_almost_eq(_sky.schwarzschild_radius, HoleInRoom.LEAST_RADIUS, 1e-6)
	var ahead := HoleInRoom.LEAST_RADIUS * HoleInRoom.WALK_RADII
	var wanted := Vector3(1.0 - ahead * cos(HoleInRoom.DIP), 1.2 - ahead * sin(HoleInRoom.DIP), 2.0)
	assert_almost_eq(_sky.global_position, wanted, Vector3.ONE * 1e-5)


func test_a_hall_has_it_in_the_middle_as_large_as_fits() -> void:
	_hole.place(_square(8.0), Transform3D(Basis.IDENTITY, Vector3(0.0, 1.7, 3.9)))
	var walk := 4.0 - HoleInRoom.MARGIN
	assert_almost_eq(_sky.schwarzschild_radius, walk / HoleInRoom.WALK_RADII, 1e-5)
	var height := 1.7 - walk * sin(HoleInRoom.DIP)
	assert_almost_eq(_sky.global_position, Vector3(0.0, height, 0.0), Vector3.ONE * 1e-5)


func test_nobody_stands_in_it_at_first() -> void:
	_hole.place(_square(8.0), Transform3D(Basis.IDENTITY, Vector3(0.1, 1.7, 0.0)))
	var away := _sky.global_position.distance_to(Vector3(0.1, 1.7, 0.0))
	assert_gt(away / _sky.schwarzschild_radius, 3.0)


func test_sizes_have_limits() -> void:
	assert_almost_eq(HoleInRoom.fitting_radius(0.0), HoleInRoom.LEAST_RADIUS, 1e-6)
	assert_almost_eq(HoleInRoom.fitting_radius(1e3), HoleInRoom.LARGEST_RADIUS, 1e-6)
	assert_eq(HoleInRoom.free_radius(_square(0.5)), 0.0, "no room at all")


func test_the_picture_fades_near_the_hole() -> void:
	var limit: NearLimit = autofree(NearLimit.new())
	assert_eq(limit.darkness(limit.fade_from), 0.0)
	assert_eq(limit.darkness(limit.black_from), 1.0)
	assert_eq(limit.darkness(0.2), 1.0)
	assert_between(limit.darkness(0.5 * (limit.fade_from + limit.black_from)), 0.4, 0.6)


func test_of_several_veils_the_darkest_counts() -> void:
	var curtain: Curtain = autofree(Curtain.new())
	curtain.set_darkness(self, 0.3)
	curtain.set_darkness(_sky, 0.7)
	assert_true(curtain.visible)
	assert_almost_eq(curtain.get_darkness(), 0.7, 1e-6)
	curtain.set_darkness(_sky, 0.0)
	assert_almost_eq(curtain.get_darkness(), 0.3, 1e-6)
	curtain.set_darkness(self, 0.0)
	assert_false(curtain.visible)


func _square(side: float) -> PackedVector3Array:
	var h := 0.5 * side
	return [Vector3(-h, 0, -h), Vector3(h, 0, -h), Vector3(h, 0, h), Vector3(-h, 0, h)]
