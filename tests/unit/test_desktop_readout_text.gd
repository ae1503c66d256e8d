# SPDX-License-Identifier: MIT
extends GutTest
## Numbers on the display: four digits, the right unit, nothing where there is nothing.

var _locale: String

var _distances: Array = (
	ParameterFactory
	. named_parameters(
		["value", "expected"],
		[
			[1000.0, "1000 rₛ"],
			[123.456, "123.5 rₛ"],
			[12.0, "12.00 rₛ"],
			[1.00049, "1.000 rₛ"],
			[0.5, "0.5000 rₛ"],
			[0.0204, "0.02040 rₛ"],
			[0.0, "0 rₛ"],
			[123456.0, "123456 rₛ"],
			[NAN, "– rₛ"],
		]
	)
)
var _exposures: Array = ParameterFactory.named_parameters(
	["value", "expected"], [[0.0, "0 EV"], [1.5, "+1.5 EV"], [-0.5, "−0.5 EV"], [8.0, "+8.0 EV"]]
)


func before_all() -> void:
	_locale = TranslationServer.get_locale()
	TranslationServer.set_locale("en")


func after_all() -> void:
	TranslationServer.set_locale(_locale)


func test_distance(p: Variant = use_parameters(_distances)) -> void:
	var value: float = p.value
	assert_eq(ReadoutText.distance(value), p.expected)


func test_exposure(p: Variant = use_parameters(_exposures)) -> void:
	var value: float = p.value
	assert_eq(ReadoutText.exposure(value), p.expected)


func test_angle_is_in_degrees() -> void:
	assert_eq(ReadoutText.angle(PI), "180.0°")
	assert_eq(ReadoutText.angle(deg_to_rad(28.5380546)), "28.54°")
	assert_eq(ReadoutText.angle(NAN), ReadoutText.NOTHING)


func test_names() -> void:
	assert_string_contains(ReadoutText.observer(LensingTable.MOTION_STATIC), "static")
	assert_string_contains(ReadoutText.observer(LensingTable.MOTION_RAIN), "rain")
	assert_eq(ReadoutText.background(BlackHoleSky.BACKGROUND_NONE), "no background")
	assert_eq(ReadoutText.background(BlackHoleSky.BACKGROUND_GRID), "grid")
	assert_eq(ReadoutText.background(BlackHoleSky.BACKGROUND_PANORAMA), "Milky Way")
	assert_eq(ReadoutText.image_orders(1), "1 image order")
	assert_eq(ReadoutText.image_orders(3), "3 image orders")


func test_large_numbers_have_words() -> void:
	assert_eq(ReadoutText.counted(354.4), "354.4")
	assert_eq(ReadoutText.counted(12.7e6), "12.70 million")
	assert_eq(ReadoutText.counted(-6.5e9), "-6.500 billion")
	assert_eq(ReadoutText.kilometres(2.0, 29.53), "59.06 km")


func test_durations() -> void:
	assert_eq(ReadoutText.duration(0.0), "0 s")
	assert_eq(ReadoutText.duration(49.3e-6), "49.30 µs")
	assert_eq(ReadoutText.duration(12.0), "12.00 s")
	assert_eq(ReadoutText.duration(90.0), "1.500 minutes")
	assert_eq(ReadoutText.duration(-7200.0), "-2.000 hours")
	assert_eq(ReadoutText.duration(43200.0 * 3.0), "1.500 days")
	assert_eq(ReadoutText.duration(31557600.0 * 100.0), "100.0 years")
	assert_eq(ReadoutText.duration(NAN), ReadoutText.NOTHING)


func test_speeds_clocks_and_accelerations() -> void:
	assert_eq(ReadoutText.speed(0.5), "0.5000 c")
	assert_eq(ReadoutText.speed(0.99999), "> 0.9999 c")
	assert_eq(ReadoutText.clock_rate(0.5), "× 0.5000")
	assert_eq(ReadoutText.clock_rate(NAN), ReadoutText.NOTHING)
	assert_eq(ReadoutText.acceleration(2.0, 1.5e6), "3.000 million g")
