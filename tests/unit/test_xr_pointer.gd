# SPDX-License-Identifier: MIT
extends GutTest
## Pointing and choosing, by hand and by looking.

const STEP: float = 0.02

var _pointer: XrPointer
var _head: Node3D
var _left: FakeHand
var _right: FakeHand
var _comfort: Comfort
var _ball: Ball
var _far: Ball


## A ball of 0.2 m that remembers what is done to it.
class Ball:
	extends PointTarget
	var part: Variant = "ball"
	var dwell: float = 1.0
	var pointed: int = 0
	var left: int = 0
	var choices: int = 0
	var let_goes: int = 0

	func distance_along(from: Vector3, direction: Vector3) -> float:
		var along := (global_position - from).dot(direction)
		var off := (from + direction * along).distance_to(global_position)
		return along if along > 0.0 and off < 0.2 else INF

	func point_at(_place: Vector3) -> void:
		pointed += 1

	func leave() -> void:
		left += 1

	func dwell_seconds() -> float:
		return dwell

	func what_is_pointed_at() -> Variant:
		return part

	func choose() -> bool:
		choices += 1
		return true

	func let_go() -> void:
		let_goes += 1


func before_each() -> void:
	_head = Node3D.new()
	_head.position = Vector3(0.0, 1.6, 0.0)
	_left = _hand(&"left_hand", Vector3(-0.3, 1.3, -0.3))
	_right = _hand(&"right_hand", Vector3(0.3, 1.3, -0.3))
	_comfort = Comfort.new()
	_ball = Ball.new()
	_ball.position = Vector3(0.0, 1.6, -2.0)
	_far = Ball.new()
	_far.position = Vector3(0.0, 1.6, -4.0)
	_pointer = XrPointer.new()
	_pointer.head = _head
	_pointer.hands = [_left, _right]
	_pointer.comfort = _comfort
	for node: Node in [_head, _left, _right, _comfort, _ball, _far, _pointer]:
		add_child_autofree(node)
	_pointer.set_process(false)
	watch_signals(_pointer)


func _hand(tracker: StringName, place: Vector3) -> FakeHand:
	var hand := FakeHand.new()
	hand.tracker = tracker
	hand.position = place
	hand.here = false
	return hand


func _let_pass(seconds: float) -> void:
	for i in ceili(seconds / STEP):
		_pointer.advance(STEP)


func test_the_hand_points_at_the_nearest() -> void:
	_right.here = true
	_right.position = Vector3(0.0, 1.6, -0.3)
	_let_pass(0.1)
	assert_false(_pointer.is_by_gaze())
	assert_eq(_pointer.get_target(), _ball)
	assert_eq(_far.pointed, 0)
	_ball.hide()
	_let_pass(0.1)
	assert_eq(_pointer.get_target(), _far, "what cannot be seen does not count")
	assert_eq(_ball.left, 1)
	_right.aim_at(Vector3(0.0, 1.6, 5.0))
	_let_pass(0.1)
	assert_null(_pointer.get_target())
	assert_eq(_far.left, 1)
	assert_signal_emit_count(_pointer, "pointed_at", 3)
	assert_eq(_right.pulses, PackedFloat32Array([0.2, 0.2]), "one for each thing")


func test_the_trigger_chooses_once() -> void:
	_right.here = true
	_right.aim_at(_ball.position)
	_let_pass(0.1)
	_right.press()
	_let_pass(3.0)
	assert_eq(_ball.choices, 1)
	assert_eq(_ball.let_goes, 0)
	_right.release()
	assert_eq(_ball.let_goes, 1)
	assert_signal_emit_count(_pointer, "chosen", 1)
	assert_almost_eq(_right.pulses[-1], 0.5, 1e-6)


func test_let_go_reaches_what_was_chosen() -> void:
	_right.here = true
	_right.aim_at(_ball.position)
	_let_pass(0.1)
	_right.press()
	_right.aim_at(Vector3(5.0, 1.6, 0.0))
	_let_pass(0.1)
	_right.release()
	assert_eq(_ball.let_goes, 1)


func test_a_gaze_chooses_after_its_time_and_once() -> void:
	_let_pass(0.9)
	assert_true(_pointer.is_by_gaze())
	assert_eq(_ball.choices, 0)
	assert_almost_eq(_pointer.get_dwell(), 0.9, 0.05)
	_let_pass(0.2)
	assert_eq(_ball.choices, 1)
	assert_eq(_ball.let_goes, 1)
	_let_pass(5.0)
	assert_eq(_ball.choices, 1, "not again")
	assert_eq(_pointer.get_dwell(), 0.0)
	_head.rotation.y = 1.0
	_let_pass(0.1)
	_head.rotation.y = 0.0
	_let_pass(0.9)
	assert_eq(_ball.choices, 1)
	_let_pass(0.2)
	assert_eq(_ball.choices, 2, "after the gaze had left it")


func test_another_part_begins_a_new_wait() -> void:
	_let_pass(0.8)
	_ball.part = 7
	_let_pass(0.8)
	assert_eq(_ball.choices, 0)
	_let_pass(0.3)
	assert_eq(_ball.choices, 1)
	_ball.part = _far
	_let_pass(1.1)
	assert_eq(_ball.choices, 2, "the next part can be chosen too")


func test_some_things_are_not_for_gazes() -> void:
	_ball.part = null
	_let_pass(3.0)
	_ball.part = "part"
	_ball.dwell = INF
	_let_pass(3.0)
	assert_eq(_ball.choices, 0)


func test_hands_at_rest_leave_pointing_to_the_gaze() -> void:
	_right.here = true
	_right.aim_at(_far.position + Vector3(3.0, 0.0, 0.0))
	_let_pass(4.0)
	assert_false(_pointer.is_by_gaze(), "it has just come")
	# It trembles a little, as every hand does.
	for i in 100:
		_right.position.x += 0.002 if i % 2 == 0 else -0.002
		_pointer.advance(STEP)
	assert_true(_pointer.is_by_gaze())
	assert_eq(_pointer.get_target(), _ball)
	for i in 10:
		_right.rotate_y(0.02)
		_pointer.advance(STEP)
	assert_false(_pointer.is_by_gaze(), "moved")
	_let_pass(6.0)
	assert_true(_pointer.is_by_gaze())
	_right.press()
	assert_false(_pointer.is_by_gaze(), "at once")


func test_the_hand_used_last_points() -> void:
	_left.here = true
	_right.here = true
	_left.aim_at(_ball.position)
	_right.aim_at(Vector3(5.0, 1.6, 0.0))
	_let_pass(1.0)
	_left.press()
	assert_eq(_ball.choices, 1, "the left one")
	_left.release()
	_right.aim_at(_ball.position)
	_let_pass(0.2)
	_right.press()
	assert_eq(_ball.choices, 2, "chooses at once, though the left one has just been used")
	_right.release()
	_let_pass(1.0)
	for i in 10:
		_left.rotate_y(0.05)
		_pointer.advance(STEP)
	assert_null(_pointer.get_target(), "the left one has been moved, and points elsewhere")


func test_a_hand_that_does_not_count_does_nothing() -> void:
	_comfort.hands = Comfort.Hands.LEFT
	_right.here = true
	_right.aim_at(_ball.position)
	_let_pass(0.1)
	assert_true(_pointer.is_by_gaze())
	_right.press()
	assert_eq(_ball.choices, 0)


func test_things_may_go_while_pointed_at() -> void:
	_let_pass(0.1)
	remove_child(_ball)
	_ball.free()
	_let_pass(0.3)
	assert_eq(_pointer.get_target(), _far)
	_let_pass(1.1)
	assert_eq(_far.choices, 1)


func test_switched_off_it_points_at_nothing() -> void:
	_let_pass(0.1)
	_pointer.enabled = false
	_let_pass(2.0)
	assert_null(_pointer.get_target())
	assert_eq(_ball.left, 1)
	assert_eq(_ball.choices, 0)


func test_dot_and_ring_look_equally_large_at_any_distance() -> void:
	var marks: PointerMarks = add_child_autofree(PointerMarks.new())
	for distance: float in [0.4, 1.6, 30.0]:
		marks.show_cursor(_head.position + Vector3(0.0, 0.0, -distance), _head, 0.5)
		var width := marks.get_cursor_width() / distance
		assert_almost_eq(rad_to_deg(2.0 * atan(0.5 * width)), 2.4, 0.02)
