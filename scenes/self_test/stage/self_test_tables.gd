# SPDX-License-Identifier: MIT
class_name SelfTestTables
extends RefCounted
## The tables twice: as textures on the graphics card, and as the numbers that core computed.

var inverse: Texture2D
var forward: Texture2D
var planck: Texture2D
var inverse_texels: PackedFloat32Array
var forward_texels: PackedFloat32Array
var planck_texels: PackedFloat32Array


func _init(table: LensingTable) -> void:
	inverse = table.get_inverse_texture()
	forward = table.get_forward_texture()
	planck = BlackBody.get_texture()
	inverse_texels = table.get_inverse_texels()
	forward_texels = table.get_forward_texels()
	planck_texels = BlackBody.get_texels()


## A texture of these numbers, four a texel, in 32-bit or, to see what such a card would do, 16-bit
## floats.
static func texture_of(
	texels: PackedFloat32Array, width: int, format: Image.Format = Image.FORMAT_RGBAF
) -> ImageTexture:
	@warning_ignore("integer_division")
	var height := texels.size() / (4 * width)
	var image := Image.create_from_data(
		width, height, false, Image.FORMAT_RGBAF, texels.to_byte_array()
	)
	image.convert(format)
	return ImageTexture.create_from_image(image)
