# SPDX-License-Identifier: MIT
extends GutTest
## Motion settles smoothly, and covers the same way at every frame rate.

const TARGET := Vector3(1.0, -2.0, 0.5)
const EPS := Vector3(1e-4, 1e-4, 1e-4)


func _way(rate: EasedRate, seconds: float, steps: int) -> Vector3:
	var way := Vector3.ZERO
	for i in steps:
		way += rate.advance(TARGET, seconds / steps)
	return way


func test_a_rate_covers_the_same_way_at_every_frame_rate() -> void:
	var coarse := _way(EasedRate.new(0.2), 0.5, 3)
	var fine := _way(EasedRate.new(0.2), 0.5, 300)
	assert_almost_eq(coarse, fine, EPS)


func test_a_rate_follows_the_formula() -> void:
	var rate := EasedRate.new(0.2)
	var way := rate.advance(TARGET, 0.2)
	assert_almost_eq(rate.get_rate(), TARGET * (1.0 - exp(-1.0)), EPS)
	assert_almost_eq(way, TARGET * 0.2 * exp(-1.0), EPS)


func test_a_rate_settles_and_comes_to_rest() -> void:
	var rate := EasedRate.new(0.1)
	rate.advance(TARGET, 5.0)
	assert_almost_eq(rate.get_rate(), TARGET, EPS)
	rate.advance(Vector3.ZERO, 5.0)
	assert_almost_eq(rate.get_rate(), Vector3.ZERO, EPS)
	rate.advance(TARGET, 1.0)
	rate.stop()
	assert_eq(rate.advance(Vector3.ZERO, 1.0), Vector3.ZERO)


func test_a_remainder_is_covered_wholly() -> void:
	var remainder := EasedRemainder.new(0.05)
	remainder.add(TARGET)
	var covered := Vector3.ZERO
	for i in 100:
		covered += remainder.advance(0.016)
	assert_almost_eq(covered, TARGET, EPS)
	assert_almost_eq(remainder.get_left(), Vector3.ZERO, EPS)


func test_a_remainder_does_not_depend_on_the_frame_rate() -> void:
	var coarse := EasedRemainder.new(0.05)
	var fine := EasedRemainder.new(0.05)
	coarse.add(TARGET)
	fine.add(TARGET)
	coarse.advance(0.06)
	for i in 60:
		fine.advance(0.001)
	assert_almost_eq(coarse.get_left(), fine.get_left(), EPS)


func test_a_remainder_takes_no_nonsense() -> void:
	var remainder := EasedRemainder.new(0.05)
	remainder.add(Vector3(NAN, 0.0, INF))
	assert_eq(remainder.get_left(), Vector3.ZERO)
