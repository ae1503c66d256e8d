# SPDX-License-Identifier: MIT
extends GutTest
## What needs no renderer: 8-bit pictures are encoded already. The curve itself is measured by
## tests/render/test_capture_stage.gd.


func test_eight_bit_pictures_stay_as_they_are() -> void:
	var encoder: DisplayEncoder = add_child_autofree(DisplayEncoder.new())
	var picture := Image.create_empty(4, 3, false, Image.FORMAT_RGBA8)
	for i in 12:
		picture.set_pixelv(_pixel(i), Color8(20 * i, 255 - 20 * i, 7, 128))
	var encoded: Image = await encoder.encode(picture)
	assert_eq(encoded.get_format(), Image.FORMAT_RGB8)
	assert_eq(encoded.get_size(), Vector2i(4, 3))
	for i in 12:
		var colour := encoded.get_pixelv(_pixel(i))
		assert_eq([colour.r8, colour.g8, colour.b8], [20 * i, 255 - 20 * i, 7])


func _pixel(i: int) -> Vector2i:
	return Vector2i(i % 4, floori(0.25 * i))
