# SPDX-License-Identifier: MIT
extends GutTest
## The map beside the desktop scene's picture, in every renderer.

const SCENE: PackedScene = preload("res://scenes/desktop/desktop.tscn")

@warning_ignore("untyped_declaration")
func should_skip_script():
	return RendererScope.without_forward_plus()


func test_the_map_shows_hole_and_sky_as_bright_as_they_are() -> void:
	var scene: DesktopScene = SCENE.instantiate()
	add_child_autofree(scene)
	var map: MapWindow = scene.get_node("%Map")
	var view: MapView = map.get_node("%MapView")
	view.set_anchors_and_offsets_preset(Control.PRESET_TOP_LEFT)
	view.size = Vector2(400.0, 200.0)
	map.open()
	# Above all else on the window, a test runner's own panel too.
	map.get_canvas_layer_node().layer = 1000
	for frame in 5:
		await RenderingServer.frame_post_draw
	# As it lies on the window, not as its viewport holds it.
	var shown := get_tree().root.get_texture().get_image()
	var on_window := view.get_viewport_transform() * view.get_global_rect()
	var picture := PictureMeasure.of_image(shown.get_region(Rect2i(on_window)))
	var width := picture.width
	var height := int(picture.luminance.size() / float(width))
	assert_almost_eq(float(width) / height, 2.0, 0.05)
	assert_lt(picture.luminance[(height >> 1) * width + (width >> 1)], 1e-3, "the hole")
	assert_lt(picture.luminance[0], 1e-3, "beside the ellipse")
	var lit := 0
	var sum := 0.0
	for value in picture.luminance:
		sum += value
		lit += 1 if value > 1e-3 else 0
	assert_gt(lit, picture.luminance.size() >> 2, "sky")
	assert_lt(sum / picture.luminance.size(), 0.2, "not washed out")
