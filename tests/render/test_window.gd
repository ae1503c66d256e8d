# SPDX-License-Identifier: MIT
extends GutTest
## What the window shows: luminance by the exact sRGB curve, in every renderer.

## 255 times the sRGB curve, 1.055 x^(1/2.4) - 0.055 from 0.0031308 on.
const LEVELS: Array = [[0.25, 137], [0.02, 39], [0.002, 7], [0.9, 243]]

var _cull_mask: int = 0


func before_all() -> void:
	_cull_mask = get_tree().root.canvas_cull_mask
	# Whatever else the window shows lies over the picture.
	get_tree().root.canvas_cull_mask = 0


func after_all() -> void:
	get_tree().root.canvas_cull_mask = _cull_mask


func test_levels_on_the_screen() -> void:
	var sky := BlackHoleSky.new()
	sky.background = BlackHoleSky.BACKGROUND_PANORAMA
	add_child_autofree(SkyBooth.dark_world())
	add_child_autofree(sky)
	var camera: Camera3D = add_child_autofree(Camera3D.new())
	camera.make_current()
	var white := Image.create_empty(16, 8, false, Image.FORMAT_RGBF)
	white.fill(Color.WHITE)
	sky.panorama = ImageTexture.create_from_image(white)
	for level: Array in LEVELS:
		sky.panorama_luminance = level[0]
		for frame in 3:
			await RenderingServer.frame_post_draw
		await wait_seconds(0.1)
		var window := get_window()
		var shown := DisplayServer.screen_get_image(window.current_screen)
		if shown == null or shown.is_empty():
			pending("this display server does not hand out what the screen shows")
			return
		var colour := shown.get_pixelv(window.position + Vector2i(400, 300))
		for channel: int in [colour.r8, colour.g8, colour.b8]:
			assert_almost_eq(channel, level[1], 1, "luminance %s" % level[0])
