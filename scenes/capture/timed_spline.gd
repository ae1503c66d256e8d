# SPDX-License-Identifier: MIT
class_name TimedSpline
extends RefCounted
## A smooth curve through given points at given times, in double precision.
##
## The Catmull-Rom spline whose knots are the times: through a point it goes with the velocity of
## the parabola through that point and its two neighbours, however unevenly the times lie; at its
## ends with that of the straight line to the next point. Between two points it is a straight line.
## Before the first and after the last time it rests. See Barry & Goldman, "A recursive evaluation
## algorithm for a class of Catmull-Rom splines", SIGGRAPH 1988.

var _times: PackedFloat64Array
var _points: Array[PackedFloat64Array]


## At least two times, strictly increasing, and as many points, all with the same number of values.
func _init(times: PackedFloat64Array, points: Array[PackedFloat64Array]) -> void:
	_times = times
	_points = points


## The point at a time.
func at(time: float) -> PackedFloat64Array:
	var last := _times.size() - 1
	if time <= _times[0]:
		return _points[0]
	if time >= _times[last]:
		return _points[last]
	var start := _times.bsearch(time, false) - 1
	var from := _times[start]
	var before := _times[start - 1] if start > 0 else 2.0 * from - _times[1]
	var after := _times[start + 2] if start + 1 < last else 2.0 * _times[last] - from
	var span := _times[start + 1] - from
	var point: PackedFloat64Array = []
	for i in _points[0].size():
		var value := cubic_interpolate_in_time(
			_points[start][i],
			_points[start + 1][i],
			_points[start - 1][i] if start > 0 else 2.0 * _points[0][i] - _points[1][i],
			(
				_points[start + 2][i]
				if start + 1 < last
				else 2.0 * _points[last][i] - _points[start][i]
			),
			(time - from) / span,
			span,
			before - from,
			after - from
		)
		point.append(value)
	return point
