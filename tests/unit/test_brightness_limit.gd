# SPDX-License-Identifier: MIT
extends RigCase
## The exposure is taken back where an observer's sky would blind, and given back afterwards.

var _limit: BrightnessLimit


func before_each() -> void:
	super()
	sky.exposure = 1.5
	_limit = BrightnessLimit.new()
	_limit.sky = sky
	_limit.head = head
	add_child(_limit)


func after_each() -> void:
	if is_instance_valid(_limit):
		_limit.free()


func test_far_away_nothing_is_taken() -> void:
	_stand(20.0)
	assert_eq(_limit.excess_ev(), 0.0)
	_limit._process(1.0)
	assert_eq(sky.exposure, 1.5)


func test_a_static_observers_sky_grows_with_the_fourth_power_of_the_shift() -> void:
	_stand(1.2)
	var gain := log(pow(1.0 - 1.0 / 1.2, -2.0)) / log(2.0)
	assert_almost_eq(_limit.excess_ev() + _limit.allowed_ev, gain, 1e-3)


func test_a_thin_bright_ring_does_not_make_the_rest_black() -> void:
	sky.observer = SkyObserver.new()
	sky.observer.motion = LensingTable.MOTION_RAIN
	_stand(0.5)
	var ahead := sky.observer.trace(Vector3(0.0, 0.0, 0.5), Vector3(1.0, 0.0, -0.6))
	assert_gt(4.0 * log(ahead["redshift"]) / log(2.0), 3.0, "beside the shadow")
	assert_lt(_limit.excess_ev(), 2.5)


func test_it_is_taken_gently_and_given_back() -> void:
	_stand(1.1)
	var excess := _limit.excess_ev()
	assert_gt(excess, 1.0)
	_limit._process(0.02)
	assert_between(1.5 - sky.exposure, 0.001, 0.2 * excess, "not at once")
	for i in 400:
		_limit._process(0.02)
	assert_almost_eq(1.5 - sky.exposure, excess, 0.05)
	sky.exposure += 1.0  # the visitor wants it brighter
	_stand(20.0)
	for i in 400:
		_limit._process(0.02)
	assert_almost_eq(sky.exposure, 2.5, 1e-3, "the wish stays")


func test_nothing_is_left_of_it_when_it_goes() -> void:
	_stand(1.1)
	for i in 100:
		_limit._process(0.02)
	_limit.free()
	assert_almost_eq(sky.exposure, 1.5, 1e-4)


func _stand(radius: float) -> void:
	rig.jump_to(Vector3(0.0, 0.0, radius * sky.schwarzschild_radius))
	_limit.look_round()
