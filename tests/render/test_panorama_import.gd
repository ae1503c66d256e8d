# SPDX-License-Identifier: MIT
extends GutTest
## A panorama of high dynamic range that the import has compressed is pointed out, with the remedy.

@warning_ignore("untyped_declaration")
func should_skip_script():
	return RendererScope.mobile_alone()


func test_a_compressed_picture_is_pointed_out() -> void:
	assert_true(_warned(_picture("res://crushed.exr", Image.FORMAT_RGB8)))
	assert_true(_warned(_picture("res://crushed.hdr", Image.FORMAT_RGBA8)))


func test_a_good_one_is_not() -> void:
	assert_false(_warned(_picture("res://good.exr", Image.FORMAT_RGBH)))
	assert_false(_warned(_picture("res://good.hdr", Image.FORMAT_RGBE9995)))
	assert_false(_warned(_picture("res://usual.png", Image.FORMAT_RGB8)))
	assert_false(_warned(load(MilkyWay.FILE) as Texture2D))


func _picture(path: String, format: Image.Format) -> Texture2D:
	var image := Image.create_empty(16, 8, false, Image.FORMAT_RGBF)
	image.convert(format)
	var texture := ImageTexture.create_from_image(image)
	texture.take_over_path(path)
	return texture


func _warned(panorama: Texture2D) -> bool:
	var sky: BlackHoleSky = autofree(BlackHoleSky.new())
	sky.panorama = panorama
	for warning in sky.get_warnings():
		if warning.contains("compressed") and warning.contains(panorama.resource_path):
			return true
	return false
