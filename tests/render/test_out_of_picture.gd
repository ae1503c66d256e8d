# SPDX-License-Identifier: MIT
extends GutTest
## Stars that are out of the picture are not drawn, and none that is in it is left out: pictures
## equal those of a sky that has to draw all of them, since a reflection probe sees it as well.

const OUTWARD := Vector3(0.36, -0.48, 0.8)
const STEPS: int = 8
## Sums of half floats, or of 8 bits, in one order of drawing.
const TOLERANCE: float = 1.0 / 255.0

var _booth: SkyBooth
var _whole: SkyBooth

@warning_ignore("untyped_declaration")
func should_skip_script():
	return RendererScope.mobile_alone()


func before_each() -> void:
	_booth = _new_booth()
	_whole = _new_booth()
	var probe := ReflectionProbe.new()
	probe.update_mode = ReflectionProbe.UPDATE_ONCE
	_whole.viewport.add_child(probe)


func _new_booth() -> SkyBooth:
	var booth := SkyBooth.new()
	booth.viewport.size = Vector2i(640, 360)
	booth.sky.image_orders = 2
	add_child_autofree(booth)
	var stars := StarCatalogue.new()
	stars.load_file(SkyBooth.CATALOGUE_FILE)
	booth.sky.catalogue = stars
	return booth


func test_a_camera_that_turns_and_moves() -> void:
	for from: float in [0.0, 1.2, 2.9]:
		for step in STEPS:
			var place := OUTWARD * (6.0 - 0.1 * step)
			var look := Transform3D(Basis.IDENTITY, place).looking_at(Vector3.ZERO)
			var turn := Basis(Vector3.UP, from + 0.09 * step) * Basis(Vector3.BACK, 0.2 * step)
			_place(look * Transform3D(turn, Vector3.ZERO))
			await _judge("%s, step %d" % [from, step], step == STEPS - 1)


func test_after_a_jump() -> void:
	for turn: float in [0.0, 2.0, -0.7, 1.5]:
		var look := Transform3D(Basis.IDENTITY, 12.0 * OUTWARD).looking_at(Vector3.ZERO)
		_place(look * Transform3D(Basis(Vector3.RIGHT, turn), Vector3.ZERO))
		await _judge("turned by %s" % turn)


func test_lenses() -> void:
	var look := Transform3D(Basis.IDENTITY, 5.0 * OUTWARD).looking_at(Vector3.ZERO)
	_place(look * Transform3D(Basis(Vector3.UP, 0.8), Vector3.ZERO))
	var lenses: Dictionary[String, Callable] = {
		"wide": func(camera: Camera3D) -> void: camera.set_perspective(130.0, 0.05, 4000.0),
		"narrow": func(camera: Camera3D) -> void: camera.set_perspective(8.0, 0.05, 4000.0),
		"beside its axis":
		func(camera: Camera3D) -> void: camera.set_frustum(0.1, Vector2(0.15, -0.1), 0.1, 4000.0),
		"parallel": func(camera: Camera3D) -> void: camera.set_orthogonal(4.0, 0.05, 4000.0),
	}
	for lens: String in lenses:
		for booth: SkyBooth in [_booth, _whole]:
			lenses[lens].call(booth.camera)
		await _judge(lens)


func test_glare_reaches_into_the_picture() -> void:
	for booth: SkyBooth in [_booth, _whole]:
		booth.sky.psf_model = BlackHoleSky.PSF_EYE
		booth.sky.exposure = 6.0
	var look := Transform3D(Basis.IDENTITY, 9.0 * OUTWARD).looking_at(Vector3.ZERO)
	for turn: float in [0.4, 1.1]:
		_place(look * Transform3D(Basis(Vector3.UP, turn), Vector3.ZERO))
		await _judge("turned by %s" % turn)


func test_moving_observers() -> void:
	for motion: LensingTable.Motion in [LensingTable.MOTION_RAIN, LensingTable.MOTION_ORBIT]:
		for booth: SkyBooth in [_booth, _whole]:
			booth.sky.observer_motion = motion
		var look := Transform3D(Basis.IDENTITY, 3.0 * OUTWARD).looking_at(Vector3.ZERO)
		for turn: float in [0.0, 1.6]:
			_place(look * Transform3D(Basis(Vector3.UP, turn), Vector3.ZERO))
			await _judge("motion %d, turned by %s" % [motion, turn])


func _place(camera: Transform3D) -> void:
	_booth.camera.transform = camera
	_whole.camera.transform = camera


# Pictures of the same next frame; `judged`: else they are only drawn.
func _judge(what: String, judged: bool = true) -> void:
	for booth: SkyBooth in [_booth, _whole]:
		booth.viewport.render_target_update_mode = SubViewport.UPDATE_ONCE
	await RenderingServer.frame_post_draw
	if not judged:
		return
	var seen := _booth.viewport.get_texture().get_image()
	var expected := _whole.viewport.get_texture().get_image()
	var worst := 0.0
	var bright := 0
	for y in seen.get_height():
		for x in seen.get_width():
			var wanted := expected.get_pixel(x, y).get_luminance()
			var off := absf(seen.get_pixel(x, y).get_luminance() - wanted)
			worst = maxf(worst, off / maxf(wanted, 1.0))
			bright += 1 if wanted > 0.004 else 0
	assert_gt(bright, 20, "%s: stars in the picture" % what)
	assert_lt(worst, TOLERANCE, what)
