# SPDX-License-Identifier: MIT
extends GutTest
## One sky, one frame, several cameras: each picture is right for its own place.

const TOLERANCE_PX: float = 0.05

var _sky: BlackHoleSky
var _cull_mask: int = 0


func before_each() -> void:
	var root := get_tree().root
	_cull_mask = root.canvas_cull_mask
	# Whatever else the window shows lies over the picture.
	root.canvas_cull_mask = 0
	_sky = BlackHoleSky.new()
	_sky.table = SkyBooth.committed_table()
	_sky.image_orders = 4
	_sky.magnitude_limit = 99.0
	add_child_autofree(SkyBooth.dark_world())
	add_child_autofree(_sky)


func after_each() -> void:
	get_tree().root.canvas_cull_mask = _cull_mask


func test_main_camera_and_two_sub_viewports() -> void:
	var rng := RandomNumberGenerator.new()
	rng.seed = 11
	var field := StarField.random(rng, 400)
	_sky.catalogue = field.catalogue()
	var places: Array[Vector3] = [Vector3(2, 1, 9), Vector3(-1, 0.4, 1.5), Vector3(30, -40, 20)]
	var views: Array[ExactView] = []
	var viewports: Array[Viewport] = []
	for i in 3:
		var view := ExactView.new(places[i], LensingTable.MOTION_STATIC)
		view.look_beside(view.shadow_half_angle() + 0.15, Vector3(0.3, 1, i), i)
		var viewport := get_viewport() if i == 0 else _sub_viewport()
		view.size = Vector2i(viewport.get_visible_rect().size)
		var camera := Camera3D.new()
		camera.fov = view.vertical_fov_deg
		camera.transform = view.camera_transform(1.0)
		if i == 0:
			add_child_autofree(camera)
		else:
			viewport.add_child(camera)
		camera.make_current()
		views.append(view)
		viewports.append(viewport)
	for frame in 3:
		await RenderingServer.frame_post_draw
	for i in 3:
		var picture := viewports[i].get_texture().get_image()
		assert_eq(picture.get_size(), views[i].size)
		_judge(picture, field.alone(views[i]), "r = %s" % places[i].length())


func _judge(picture: Image, targets: Array[StarField.Target], whose: String) -> void:
	var worst := 0.0
	var lensed := 0
	for target in targets:
		var off := PicturePatch.centroid(picture, target.pixel).distance_to(target.pixel)
		worst = off if not off <= worst else worst
		lensed += 1 if target.order > 0 else 0
	gut.p(
		"%s: %d images, %d of them lensed, worst %.4f px" % [whose, targets.size(), lensed, worst]
	)
	assert_gte(targets.size(), 10, "%s: images measured" % whose)
	assert_lt(worst, TOLERANCE_PX, "%s: worst centroid" % whose)


func _sub_viewport() -> SubViewport:
	var viewport := SubViewport.new()
	viewport.size = Vector2i(1280, 720)
	viewport.use_hdr_2d = true
	viewport.render_target_update_mode = SubViewport.UPDATE_ALWAYS
	add_child_autofree(viewport)
	return viewport
