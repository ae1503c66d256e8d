# SPDX-License-Identifier: MIT
extends GutTest
## Smooth curves through points at uneven times.

const TIMES: PackedFloat64Array = [0.5, 1.0, 3.0, 3.25, 7.0]
const STEP: float = 1e-6


func test_it_passes_the_points_at_their_times() -> void:
	var points := _points([[0, 5], [1, -2], [4, 4], [-3, 1e12], [2, 0]])
	var spline := TimedSpline.new(TIMES, points)
	for i in TIMES.size():
		_expect(spline.at(TIMES[i]), points[i])


func test_it_rests_before_and_after() -> void:
	var spline := TimedSpline.new([1.0, 2.0], _points([[3, 4], [5, 6]]))
	for time: float in [-1.0, 0.0, 1.0]:
		assert_eq(spline.at(time), PackedFloat64Array([3.0, 4.0]))
	for time: float in [2.0, 2.5, 1e6]:
		assert_eq(spline.at(time), PackedFloat64Array([5.0, 6.0]))


func test_two_points_are_a_line_at_even_speed() -> void:
	var spline := TimedSpline.new([1.0, 5.0], _points([[0, 8], [4, -8]]))
	for time: float in [1.5, 2.0, 4.9]:
		_expect(spline.at(time), [time - 1.0, 8.0 - 4.0 * (time - 1.0)])


func test_a_motion_at_even_speed_stays_even_whatever_the_times() -> void:
	var points: Array[PackedFloat64Array] = []
	for time in TIMES:
		points.append([3.0 - 2.0 * time])
	var spline := TimedSpline.new(TIMES, points)
	for step in 66:
		var time := 0.5 + 0.1 * step
		_expect(spline.at(minf(time, 7.0)), [3.0 - 2.0 * minf(time, 7.0)])


func test_parabolas_are_exact_between_inner_points() -> void:
	var parabola := func(time: float) -> float: return 2.0 - time + 0.5 * time * time
	var points: Array[PackedFloat64Array] = []
	for time in TIMES:
		points.append([parabola.call(time)])
	var spline := TimedSpline.new(TIMES, points)
	for time: float in [1.0, 1.7, 2.9, 3.0, 3.1, 3.249]:
		_expect(spline.at(time), [parabola.call(time)])


func test_no_jump_of_the_velocity_at_a_point() -> void:
	var spline := TimedSpline.new(TIMES, _points([[0], [1], [4], [-3], [2]]))
	for i in range(1, 4):
		var before := (spline.at(TIMES[i])[0] - spline.at(TIMES[i] - STEP)[0]) / STEP
		var after := (spline.at(TIMES[i] + STEP)[0] - spline.at(TIMES[i])[0]) / STEP
		assert_almost_eq(before, after, 1e-3 * (1.0 + absf(before)), "at %s" % TIMES[i])


func _points(rows: Array) -> Array[PackedFloat64Array]:
	var points: Array[PackedFloat64Array] = []
	for row: Array in rows:
		points.append(PackedFloat64Array(row))
	return points


func _expect(got: PackedFloat64Array, expected: PackedFloat64Array) -> void:
	assert_eq(got.size(), expected.size())
	for i in expected.size():
		assert_almost_eq(got[i], expected[i], 1e-12 * (1.0 + absf(expected[i])))
