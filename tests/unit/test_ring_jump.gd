# SPDX-License-Identifier: MIT
extends RigCase
## One jumps to the ring that one points at where it is seen, and has the hole on the same side
## afterwards.

var _jump: RingJump
var _rings: AccretionDisk


func before_each() -> void:
	super()
	comfort.blinks = false
	_rings = AccretionDisk.new()
	sky.add_child(_rings)
	_jump = RingJump.new()
	_jump.rig = rig
	_jump.head = head
	_jump.sky = sky
	_jump.rings = _rings
	put(_jump)
	rig.jump_to(_jump.stand(6.0, PI))


func test_the_near_side_of_a_ring_is_found_by_looking() -> void:
	# In front of the hole light is hardly bent.
	var target := sky.global_position + Vector3(0.0, 0.0, 3.0 * sky.schwarzschild_radius)
	var look := (target - head.global_position).normalized()
	assert_lt(_jump.distance_along(head.global_position, look), INF)
	_jump.point_at(target)
	assert_eq(_jump.get_ring(), 3.0)
	assert_eq(_rings.ring_highlight, 0)
	_jump.leave()
	assert_eq(_jump.get_ring(), 0.0)
	assert_eq(_rings.ring_highlight, -1)


func test_a_hand_points_at_what_the_eye_sees() -> void:
	var target := sky.global_position + Vector3(0.0, 0.0, 3.0 * sky.schwarzschild_radius)
	var look := (target - head.global_position).normalized()
	# On the beam's way through the hole's own plane across the view.
	var ahead := (sky.global_position - head.global_position).normalized()
	var there := head.global_position + look * rig.get_radius_metres() / look.dot(ahead)
	var hand := head.global_position + Vector3(0.3, -0.4, -0.2)
	var distance := _jump.distance_along(hand, (there - hand).normalized())
	assert_almost_eq(distance, hand.distance_to(there), 1e-3)
	assert_eq(_jump.what_is_pointed_at(), 0)


func test_nothing_is_hit_in_the_shadow_between_rings_and_behind() -> void:
	var eye := head.global_position
	var to_hole := (sky.global_position - eye).normalized()
	assert_eq(_jump.distance_along(eye, -to_hole), INF, "behind")
	var between := sky.global_position + Vector3(0.0, 0.0, 3.45 * sky.schwarzschild_radius)
	_jump.reach = 1.05
	assert_eq(_jump.distance_along(eye, (between - eye).normalized()), INF, "between two rings")
	assert_false(_jump.choose(), "nothing to choose")
	_jump.enabled = false
	var target := sky.global_position + Vector3(0.0, 0.0, 3.0 * sky.schwarzschild_radius)
	assert_eq(_jump.distance_along(eye, (target - eye).normalized()), INF, "switched off")
	assert_false(_rings.visible)


func test_a_jump_leads_to_the_ring_with_the_hole_on_the_same_side() -> void:
	var seen := head.global_basis.inverse() * -rig.get_place().normalized()
	_jump.jump(4.0, 1.2)
	assert_almost_eq(rig.get_radius(), 4.0, 1e-4)
	var place := rig.get_place().normalized()
	assert_almost_eq(rad_to_deg(asin(place.y)), _jump.latitude_degrees, 1e-3)
	assert_almost_eq(atan2(-place.x, -place.z), 1.2, 1e-4)
	var now := head.global_basis.inverse() * -rig.get_place().normalized()
	assert_almost_eq(now, seen, Vector3.ONE * 1e-4)


func test_the_preview_tells_the_shadows_size_there() -> void:
	# Synge 1966: sin^2 psi = 27/4 (1 - 1/r) / r^2.
	for radius: float in [3.0, 10.0]:
		var sine := sqrt(6.75 * (1.0 - 1.0 / radius)) / radius
		assert_almost_eq(RingJump.shadow_there(radius), asin(sine), 1e-6)
	var preview := ShadowPreview.new()
	preview.rig = rig
	preview.head = head
	preview.sky = sky
	preview.jump = _jump
	put(preview)
	preview.show_ring(10.0)
	assert_true(preview.visible)
	preview.show_ring(0.0)
	assert_false(preview.visible)
