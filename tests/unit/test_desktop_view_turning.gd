# SPDX-License-Identifier: MIT
extends GutTest
## The eye's turning where it is: freely, and towards the hole.

const EPS: float = 2e-5

var _rig: ViewRig


func before_each() -> void:
	_rig = ViewRig.new()
	_rig.look_from(Vector3(0.0, 0.0, 10.0), Vector3.UP)


func _forward() -> Vector3:
	return _rig.get_orientation() * Vector3.FORWARD


func _assert_near(got: Vector3, expected: Vector3, within: float, text: String = "") -> void:
	assert_lt(got.distance_to(expected), within, "%s: got %s, expected %s" % [text, got, expected])


func _assert_sound(text: String) -> void:
	assert_true(_rig.get_position().is_finite(), text + ": position is finite")
	assert_true(_rig.get_orientation().is_finite(), text + ": orientation is finite")
	assert_almost_eq(_rig.get_orientation().length(), 1.0, 1e-5, text + ": a rotation")
	var within := ViewRig.FARTHEST * 1.00001
	assert_between(_rig.get_distance(), ViewRig.NEAREST * 0.99999, within, text)


func test_turn_keeps_the_place() -> void:
	_rig.turn(PI / 2.0, 0.0, 0.0)
	_assert_near(_forward(), Vector3.RIGHT, EPS, "to the right")
	_rig.turn(0.0, PI / 2.0, 0.0)
	_assert_near(_forward(), Vector3.UP, EPS, "upwards")
	_assert_near(_rig.get_position(), Vector3(0.0, 0.0, 10.0), EPS, "place")


func test_roll_to_the_right_keeps_the_view() -> void:
	_rig.turn(0.0, 0.0, PI / 2.0)
	_assert_near(_forward(), Vector3.FORWARD, EPS, "view")
	_assert_near(_rig.get_orientation() * Vector3.UP, Vector3.RIGHT, EPS, "head to the right")


func test_face_hole_from_any_side() -> void:
	for away: float in [0.0, 1e-4, 1.0, 3.0, PI - 1e-4, PI]:
		_rig.look_from(Vector3(0.0, 0.0, 10.0), Vector3.UP)
		_rig.turn(away, 0.0, 0.0)
		for i in 100:
			_rig.face_hole(0.2)
		_assert_sound("from %s" % away)
		_assert_near(_forward(), Vector3.FORWARD, 1e-3, "from %s" % away)


func test_face_hole_does_not_depend_on_the_steps() -> void:
	_rig.turn(1.0, 0.5, 0.2)
	var many := ViewRig.new()
	many.place(_rig.get_position(), _rig.get_orientation())
	_rig.face_hole(1.0 - exp(-1.0))
	for i in 20:
		many.face_hole(1.0 - exp(-1.0 / 20.0))
	_assert_near(many.get_orientation() * Vector3.FORWARD, _forward(), 1e-4)


func test_look_from_along_the_upward_direction() -> void:
	for place: Vector3 in [Vector3.UP * 5.0, Vector3.DOWN * 5.0, Vector3.UP * 500.0]:
		_rig.look_from(place, Vector3.UP)
		_assert_sound("from %s" % place)
		_assert_near(_forward(), -place.normalized(), 1e-4, "from %s" % place)
