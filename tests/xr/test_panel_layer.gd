# SPDX-License-Identifier: MIT
extends XrTestCase
## The menu as a layer of the runtime's own: shown where the runtime can and only when asked for,
## and the panel in the world can be used in any case.


func test_the_layer_comes_and_goes_with_the_menu() -> void:
	if not await begun():
		return
	var scene := visit.scene
	scene.sky.visible = false
	var layer := scene.menu_layer
	scene.menu.open(scene.head.global_transform)
	await wait_process_frames(3)
	assert_false(layer.is_shown(), "not asked for")
	scene.menu.close()
	layer.enabled = true
	scene.menu.open(scene.head.global_transform)
	await wait_process_frames(5)
	gut.p("the runtime %s" % ("can" if layer.is_natively_supported() else "cannot"))
	assert_eq(layer.is_shown(), layer.is_natively_supported())
	if layer.is_shown():
		var flat := scene.menu.surface.picture
		assert_almost_eq(layer.global_position, flat.global_position, Vector3.ONE * 1e-4)
		assert_almost_eq(layer.quad_size, flat.get_extent(), Vector2.ONE * 1e-5)
	assert_true(scene.menu.surface.picture.is_visible_in_tree(), "the panel is there as well")
	scene.menu.close()
	await wait_process_frames(3)
	assert_false(layer.is_shown())
