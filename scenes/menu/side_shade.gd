# SPDX-License-Identifier: MIT
class_name SideShade
extends TextureRect
## Darkens the picture under a column of text at its left, and fades out to the right.

## How much of the picture is still seen under the text.
const LEFT_OVER: float = 0.12


func _ready() -> void:
	var shade := Gradient.new()
	shade.offsets = PackedFloat32Array([0.0, 0.62, 1.0])
	var dark := Color(0.01, 0.015, 0.03)
	shade.colors = PackedColorArray(
		[Color(dark, 1.0 - LEFT_OVER), Color(dark, 1.0 - LEFT_OVER), Color(dark, 0.0)]
	)
	var picture := GradientTexture2D.new()
	picture.gradient = shade
	picture.width = 256
	picture.height = 4
	texture = picture
	expand_mode = TextureRect.EXPAND_IGNORE_SIZE
	stretch_mode = TextureRect.STRETCH_SCALE
