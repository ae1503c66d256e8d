# SPDX-License-Identifier: MIT
extends GutTest
## The legend of the desktop scene has the colours of the map.

## Frequency ratios to look at; at none of them is there a line.
const RATIOS: PackedFloat64Array = [0.2, 0.27, 0.47, 0.7, 0.93, 1.07, 1.4, 2.1, 3.5, 5.0]

var _booth: SkyBooth

@warning_ignore("untyped_declaration")
func should_skip_script():
	return RendererScope.without_forward_plus()


func before_all() -> void:
	_booth = SkyBooth.new()
	add_child(_booth)
	_booth.viewport.size = Vector2i(65, 65)
	_booth.camera.fov = 1.0
	_booth.sky.lensing = 0.0
	_booth.sky.redshift_map = true
	_booth.sky.stars_visible = false
	_booth.sky.background = BlackHoleSky.BACKGROUND_GRID


func after_all() -> void:
	_booth.free()


# The middle of a picture of the sky ahead, where the whole sky is shifted by the Doppler factor g.
func _map_colour(g: float) -> Color:
	var observer := SkyObserver.new()
	observer.motion = LensingTable.MOTION_VELOCITY
	# g = gamma (1 + beta): celerity (g - 1 / g) / 2 forward.
	observer.celerity = Vector3.FORWARD * (0.5 * (g - 1.0 / g))
	_booth.sky.observer = observer
	var picture: Image = await _booth.take()
	var colour := picture.get_pixel(32, 32)
	return colour.linear_to_srgb() if SkyBooth.is_linear() else colour


func test_colours_are_those_of_the_map() -> void:
	for g in RATIOS:
		var shown := await _map_colour(g)
		var expected := RedshiftScale.colour(g)
		for channel in 3:
			var value: float = shown[channel]
			var expected_value: float = expected[channel]
			assert_almost_eq(value, expected_value, 0.006, "g = %s" % g)


func test_the_line_at_one_is_black_and_others_are_darker() -> void:
	assert_eq(RedshiftScale.line_colour(1.0), Color.BLACK)
	var on_line := await _map_colour(1.0)
	assert_lt(on_line.get_luminance(), 0.01)
	# A line of the map is up to 60 % darker, in linear light.
	var expected := RedshiftScale.line_colour(2.0)
	var beside := RedshiftScale.colour(2.0)
	for channel in 3:
		var light: float = expected.srgb_to_linear()[channel]
		var light_beside: float = beside.srgb_to_linear()[channel]
		assert_almost_eq(light, 0.4 * light_beside, 1e-5)


func test_places_on_the_bar() -> void:
	assert_almost_eq(RedshiftBar.place(0.25, 200.0), 0.0, 1e-6)
	assert_almost_eq(RedshiftBar.place(1.0, 200.0), 100.0, 1e-6)
	assert_almost_eq(RedshiftBar.place(2.0, 200.0), 150.0, 1e-6)
	assert_almost_eq(RedshiftBar.place(4.0, 200.0), 200.0, 1e-6)
