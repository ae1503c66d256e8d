# SPDX-License-Identifier: MIT
class_name MarchCheck
extends RefCounted
## Is the marched picture the one that the tables give? Otherwise its time would mean nothing.

const FRAMES: int = 3


## Differences of the two pictures' luminance in units of their mean: median, 99th percentile.
static func compare(stage: BenchStage) -> Dictionary:
	var lensed := await _picture(stage, BenchStage.Picture.LENSED_PANORAMA)
	var marched := await _picture(stage, BenchStage.Picture.MARCH_1000)
	var differences := PackedFloat64Array()
	var sum := 0.0
	for i in lensed.size():
		differences.append(absf(lensed[i] - marched[i]))
		sum += lensed[i]
	differences.sort()
	var mean := maxf(sum / lensed.size(), 1e-9)
	var share := func(part: float) -> float:
		return differences[floori(part * (differences.size() - 1))] / mean
	return {"median_difference": share.call(0.5), "p99_difference": share.call(0.99)}


## Luminance of each pixel.
static func _picture(stage: BenchStage, picture: BenchStage.Picture) -> PackedFloat32Array:
	stage.show_picture(picture)
	for frame in FRAMES:
		await RenderingServer.frame_post_draw
	var image := stage.viewport.get_texture().get_image()
	var values := PackedFloat32Array()
	for y in image.get_height():
		for x in image.get_width():
			values.append(image.get_pixel(x, y).get_luminance())
	return values
