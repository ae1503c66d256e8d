# SPDX-License-Identifier: MIT
class_name BenchPanorama
extends RefCounted
## The picture on the celestial sphere that the bench draws: the Milky Way, or a pattern of its size
## where that is missing.

const PATTERN_SIZE := Vector2i(2048, 1024)

var name: String
var texture: Texture2D
var luminance: float = 1.0


static func find() -> BenchPanorama:
	var found := BenchPanorama.new()
	if ResourceLoader.exists(MilkyWay.FILE):
		found.name = MilkyWay.FILE
		found.texture = load(MilkyWay.FILE) as Texture2D
		found.luminance = MilkyWay.LUMINANCE
	if found.texture == null:
		found.name = "pattern"
		found.texture = _pattern()
		found.luminance = 1.0
	return found


static func _pattern() -> Texture2D:
	var noise := FastNoiseLite.new()
	noise.frequency = 0.02
	var picture := noise.get_seamless_image(PATTERN_SIZE.x, PATTERN_SIZE.y)
	picture.convert(Image.FORMAT_RGBH)
	picture.generate_mipmaps()
	return ImageTexture.create_from_image(picture)
