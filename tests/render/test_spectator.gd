# SPDX-License-Identifier: MIT
extends GutTest
## The spectators' view follows the head steadily, jumps with it, draws at its own pace and shows
## what each eye sees.

const SCENE: PackedScene = preload("res://scenes/xr/spectator/spectator.tscn")
const HOLE := Vector3(0.0, 1.5, -2.0)
const FRAME: float = 1.0 / 72.0

var _sky: BlackHoleSky
var _head: Camera3D
var _spectator: Spectator
var _world: WorldEnvironment
var _mark: MeshInstance3D

@warning_ignore("untyped_declaration")
func should_skip_script():
	return RendererScope.mobile_alone()


func before_each() -> void:
	_world = SkyBooth.dark_world()
	_sky = BlackHoleSky.new()
	_sky.position = HOLE
	_sky.schwarzschild_radius = 0.3
	_head = Camera3D.new()
	_head.position = Vector3(0.0, 1.6, 0.0)
	# A thing near the eyes: they see it in different directions.
	_mark = MeshInstance3D.new()
	var box := BoxMesh.new()
	box.size = Vector3.ONE * 0.1
	var material := StandardMaterial3D.new()
	material.shading_mode = BaseMaterial3D.SHADING_MODE_UNSHADED
	box.material = material
	_mark.mesh = box
	_mark.position = Vector3(0.0, 1.6, -0.6)
	_spectator = SCENE.instantiate()
	_spectator.sky = _sky
	_spectator.head = _head
	for node: Node in [_world, _sky, _head, _mark, _spectator]:
		add_child_autofree(node)
	_head.current = false
	_spectator.layer = 500
	await wait_process_frames(2)


func test_a_trembling_head_hardly_moves_the_view() -> void:
	_spectator.set_process(false)
	_spectator.pictures_per_second = 0.0
	var camera := _camera("Left")
	_spectator._process(FRAME)
	var middle := camera.global_transform
	assert_almost_eq(middle.origin, _head.position, Vector3.ONE * 1e-5)
	var widest := 0.0
	var largest := 0.0
	for i in 300:
		var phase := sin(TAU * 5.0 * i * FRAME)
		_head.position = middle.origin + Vector3(0.01 * phase, 0.0, 0.0)
		_head.basis = Basis(Vector3.UP, deg_to_rad(phase))
		_spectator._process(FRAME)
		var moved := camera.global_transform
		widest = maxf(widest, moved.origin.distance_to(middle.origin))
		largest = maxf(largest, moved.basis.z.angle_to(middle.basis.z))
	assert_between(widest, 1e-6, 0.2 * 0.01)
	assert_between(rad_to_deg(largest), 1e-4, 0.2)


func test_a_jump_is_followed_at_once() -> void:
	_spectator.set_process(false)
	_spectator._process(FRAME)
	_head.position += Vector3(0.7, 0.0, -0.5)
	_head.basis = Basis(Vector3.UP, 1.0)
	_spectator._process(FRAME)
	assert_almost_eq(_camera("Left").global_position, _head.position, Vector3.ONE * 1e-5)
	assert_lt(_camera("Left").global_basis.z.angle_to(_head.basis.z), 1e-3)
	_head.position += Vector3(0.1, 0.0, 0.0)
	_spectator._process(FRAME)
	assert_gt(_camera("Left").global_position.distance_to(_head.position), 0.09, "a step is not")


func test_what_carries_the_head_is_followed_without_delay() -> void:
	var rig := Node3D.new()
	add_child_autofree(rig)
	_head.reparent(rig)
	_spectator.set_process(false)
	_spectator.pictures_per_second = 0.0
	for i in 60:
		rig.position.x += 0.02
		_spectator._process(FRAME)
	assert_almost_eq(_camera("Left").global_position, _head.global_position, Vector3.ONE * 1e-4)


func test_each_eye_has_its_own_picture() -> void:
	_spectator.mode = Spectator.Mode.BOTH_EYES
	for eye: Array in [["Left", 1.0], ["Right", -1.0]]:
		var named: String = eye[0]
		var side: float = eye[1]
		var picture := await _picture(named)
		var middle := _middle_of_light(picture) - 0.5 * picture.width
		# Seen from its eye the mark is to the other side of the nose.
		var camera := _camera(named)
		var focal := 0.5 * picture.height / tan(0.5 * deg_to_rad(camera.fov))
		assert_almost_eq(middle, side * focal * Spectator.HALF_EYES / 0.6, 0.15 * focal * 0.05)
	var window := get_tree().root.get_texture().get_image()
	assert_eq(window.get_size(), get_window().size)
	assert_almost_eq(float(_viewport("Left").size.x), 0.5 * get_window().size.x, 2.0)


func test_pictures_are_drawn_at_their_own_pace() -> void:
	_spectator.pictures_per_second = 2.0
	await _picture("Left")
	# Right after a picture, the world changes.
	while _light("Left") <= 0.0:
		await RenderingServer.frame_post_draw
	_mark.visible = false
	var begun := Time.get_ticks_msec()
	var shown_until := begun
	while Time.get_ticks_msec() - begun < 3000 and _light("Left") > 0.0:
		shown_until = Time.get_ticks_msec()
		await RenderingServer.frame_post_draw
	assert_eq(_light("Left"), 0.0, "a new picture came")
	assert_lt(shown_until - begun, 1500, "in time")
	_mark.visible = true
	var lasted := Time.get_ticks_msec()
	while Time.get_ticks_msec() - lasted < 3000 and _light("Left") <= 0.0:
		await RenderingServer.frame_post_draw
	assert_gt(Time.get_ticks_msec() - lasted, 300, "not before its time")


func test_off_and_hidden_cameras_do_not_look() -> void:
	assert_true(_camera("Left").current)
	assert_false(_camera("Right").current)
	_spectator.mode = Spectator.Mode.OFF
	assert_false(_camera("Left").current)
	assert_false((_spectator.get_node("%Shade") as CanvasItem).visible)
	_spectator.set_caption("Horizon")
	assert_true((_spectator.get_node("%Caption") as CanvasItem).visible)
	_spectator.session = autofree(XrSession.new())
	await wait_process_frames(2)
	assert_true(_spectator.visible, "the caption stays")
	_spectator.mode = Spectator.Mode.VIEW
	await wait_process_frames(2)
	assert_false(_spectator.visible, "without a session there is nothing to show")
	assert_false(_camera("Left").current)
	_spectator.session.state = XrSession.State.FOCUSED
	await wait_process_frames(2)
	assert_true(_spectator.visible)
	assert_true(_camera("Left").current)


func test_words_can_be_read_from_afar() -> void:
	_spectator.set_caption("Horizon")
	await wait_process_frames(2)
	var rows := get_window().size.y
	var caption: Label = _spectator.get_node("%Caption")
	var distance: Label = _spectator.get_node("%Distance")
	assert_gte(caption.get_theme_font_size(&"font_size") / float(rows), 0.04)
	assert_gte(distance.get_theme_font_size(&"font_size") / float(rows), 0.026)
	assert_string_contains(distance.text, "6.675 rₛ")
	var shown := caption.get_global_rect().merge(distance.get_global_rect())
	assert_true(Rect2(Vector2.ZERO, get_window().size).encloses(shown))


func _camera(side: String) -> Camera3D:
	return _spectator.get_node("%" + side + "Camera")


func _viewport(side: String) -> SubViewport:
	return _spectator.get_node("%" + side + "Viewport")


func _picture(side: String) -> PictureMeasure:
	for frame in 6:
		await RenderingServer.frame_post_draw
	return PictureMeasure.of_image(_viewport(side).get_texture().get_image())


func _light(side: String) -> float:
	var picture := _viewport(side).get_texture().get_image()
	var middle := 0.5 * Vector2(picture.get_size())
	return picture.get_pixelv(Vector2i(middle)).r


func _middle_of_light(picture: PictureMeasure) -> float:
	var sum := 0.0
	var light := 0.0
	for i in picture.luminance.size():
		sum += picture.luminance[i] * (i % picture.width + 0.5)
		light += picture.luminance[i]
	return sum / maxf(light, 1e-9)
