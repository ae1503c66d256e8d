# SPDX-License-Identifier: MIT
extends SelfTestCase
## The self-test names the check that belongs to a fault of drawing. Faults are put into what a
## check draws; what it compares with stays.

var _folder := ScratchFolder.new("self_test")

@warning_ignore("untyped_declaration")
func should_skip_script():
	return RendererScope.mobile_alone()


func test_stars_drawn_for_another_motion() -> void:
	var check := StarPlacesCheck.new()
	check.observers[0].motion = LensingTable.MOTION_RAIN
	await _expect_of_pictures(["star_places"], check)


func test_no_stars() -> void:
	self_test.stage.sky.stars_visible = false
	var results: Array[CheckResult] = await _expect_of_pictures(["star_places", "faint_light"])
	assert_string_contains("\n".join(results[0].objections), "stars are not there")


func test_second_images_missing() -> void:
	var check := StarPlacesCheck.new()
	self_test.stage.sky.effect_higher_orders = false
	await _expect_of_pictures(["star_places"], check)


func test_light_in_the_shadow() -> void:
	var spot := ColorRect.new()
	spot.size = Vector2(2, 2)
	spot.position = 0.5 * Vector2(SelfTestStage.SIZE) + Vector2(10, 10)
	self_test.stage.viewport.add_child(spot)
	var results: Array[CheckResult] = await expect([StarPlacesCheck.new()], ["star_places"])
	assert_string_contains("\n".join(results[0].objections), "inside of the shadow")


func test_a_clipped_faint_limit() -> void:
	self_test.stage.sky.faint_limit = 0.01
	await _expect_of_pictures(["faint_light"])


func test_no_linear_buffer() -> void:
	if not SelfTestStage.is_linear():
		pass_test("There is none in Compatibility.")
		return
	self_test.stage.viewport.use_hdr_2d = false
	var results: Array[CheckResult] = await expect([FaintLightCheck.new()], ["faint_light"])
	assert_string_contains("\n".join(results[0].objections), "hdr_2d")
	assert_string_contains(results[0].remedy, "hdr_2d")


func test_a_background_for_another_motion() -> void:
	var check := BackgroundCheck.new()
	check.observer.motion = LensingTable.MOTION_RAIN
	await expect([check, FaintLightCheck.new()], ["background"])


func test_a_mirrored_background() -> void:
	var check := BackgroundCheck.new()
	var mirrored := check.panorama.get_image()
	mirrored.flip_x()
	check.panorama = ImageTexture.create_from_image(mirrored)
	var results: Array[CheckResult] = await expect([check], ["background"])
	assert_string_contains(results[0].quantity, "another part of the sky")


func test_a_shader_that_does_not_compile() -> void:
	var check := ShadersCheck.new()
	var broken := "shader_type spatial;\nvoid fragment() { ALBEDO = vec3(no_such_name); }\n"
	check.paths = [_folder.write_text("broken.gdshader", broken), check.paths[0]]
	var results: Array[CheckResult] = await expect([check, FaintLightCheck.new()], ["shaders"])
	assert_gt(get_errors().size(), 0, "the engine says so")
	for error: GutTrackedError in get_errors():
		error.handled = true
	var said := "\n".join(results[0].objections)
	assert_string_contains(said, "broken.gdshader does not compile")
	assert_string_contains(said, "The engine says")


func test_errors_of_the_engine_count() -> void:
	var results: Array[CheckResult] = await expect([_NoisyCheck.new()], ["noisy"])
	assert_push_error("the driver gave up")
	assert_string_contains(results[0].objections[0], "the driver gave up")


func _expect_of_pictures(
	faults: PackedStringArray, star_places: StarPlacesCheck = StarPlacesCheck.new()
) -> Array[CheckResult]:
	return await expect([star_places, FaintLightCheck.new(), BackgroundCheck.new()], faults)


class _NoisyCheck:
	extends SelfCheck

	func _init() -> void:
		name = &"noisy"

	func measure(stage: SelfTestStage, result: CheckResult) -> void:
		push_error("the driver gave up")
		result.compare("something", 0.0, 1.0)
		await stage.get_tree().process_frame
