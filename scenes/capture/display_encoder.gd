# SPDX-License-Identifier: MIT
class_name DisplayEncoder
extends Node
## Turns a linear-light picture into what a screen shows: clipped to 0..1, exact sRGB curve, 8 bits
## a channel, dithered by half a step.

const SHADER: String = """
shader_type canvas_item;
render_mode unshaded, blend_disabled;

// Uniform noise of half a step of 8 bits, the same in every picture: dark gradients then show no
// contours. Black stays black.
float dither(uvec2 pixel) {
	uint hash = pixel.x * 1664525u + pixel.y * 22695477u + 1013904223u;
	hash = (hash ^ (hash >> 16u)) * 2246822519u;
	hash = (hash ^ (hash >> 13u)) * 3266489917u;
	hash ^= hash >> 16u;
	return (float(hash >> 8u) / 16777216.0 - 0.5) * (0.999 / 255.0);
}

void fragment() {
	vec3 c = clamp(texelFetch(TEXTURE, ivec2(FRAGCOORD.xy), 0).rgb, vec3(0.0), vec3(1.0));
	vec3 low = c * 12.92;
	vec3 high = 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055;
	vec3 shown = mix(high, low, lessThanEqual(c, vec3(0.0031308)));
	COLOR = vec4(shown + dither(uvec2(FRAGCOORD.xy)), 1.0);
}
"""

var _viewport := SubViewport.new()
var _picture := TextureRect.new()


func _init() -> void:
	_viewport.disable_3d = true
	_viewport.use_hdr_2d = false
	_viewport.render_target_update_mode = SubViewport.UPDATE_DISABLED
	var material := ShaderMaterial.new()
	material.shader = Shader.new()
	material.shader.code = SHADER
	_picture.material = material
	_viewport.add_child(_picture)
	add_child(_viewport)


## An 8-bit sRGB picture. Pictures that are 8-bit already are encoded: the renderer did it.
func encode(picture: Image) -> Image:
	if picture.get_format() == Image.FORMAT_RGBA8 or picture.get_format() == Image.FORMAT_RGB8:
		picture.convert(Image.FORMAT_RGB8)
		return picture
	_picture.texture = ImageTexture.create_from_image(picture)
	_picture.size = picture.get_size()
	_viewport.size = picture.get_size()
	_viewport.render_target_update_mode = SubViewport.UPDATE_ONCE
	await RenderingServer.frame_post_draw
	var encoded := _viewport.get_texture().get_image()
	encoded.convert(Image.FORMAT_RGB8)
	return encoded
