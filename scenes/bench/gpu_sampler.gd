# SPDX-License-Identifier: MIT
class_name GpuSampler
extends RefCounted
## Times how long the graphics device draws each of several pictures, taking turns, so that what
## slows the machine for a while slows them all. The least of many samples is what a picture costs.

## A measured time belongs to a frame some frames back: a turn's first frames still report the
## previous picture.
const FRAMES_PER_TURN: int = 16
const FRAMES_USED: int = 4
const SAMPLES: int = 52
## So long may the turns of one slow picture take together, milliseconds; it then has fewer samples.
const SLOW_PICTURE_MS: float = 60000.0

## Least time of each picture, milliseconds, and the number of samples it comes from.
var least: PackedFloat64Array = []
var counts: PackedInt64Array = []

var _stage: BenchStage
var _viewport: RID


func _init(stage: BenchStage) -> void:
	_stage = stage
	_viewport = stage.viewport.get_viewport_rid()
	RenderingServer.viewport_set_measure_render_time(_viewport, true)
	least.resize(BenchStage.Picture.size())
	least.fill(INF)
	counts.resize(BenchStage.Picture.size())


## Takes turns over `pictures` until each has its samples.
func measure(pictures: Array[BenchStage.Picture], samples: int = SAMPLES) -> void:
	while true:
		var waiting := pictures.filter(_wants_samples.bind(samples))
		if waiting.is_empty():
			return
		for picture: BenchStage.Picture in waiting:
			await _take_turn(picture)


func _wants_samples(picture: BenchStage.Picture, samples: int) -> bool:
	if counts[picture] == 0:
		return true
	var turns := maxi(floori(SLOW_PICTURE_MS / (least[picture] * FRAMES_PER_TURN)), 1)
	return counts[picture] < mini(turns * FRAMES_USED, samples)


func _take_turn(picture: BenchStage.Picture) -> void:
	_stage.show_picture(picture)
	for frame in FRAMES_PER_TURN:
		await RenderingServer.frame_post_draw
		if frame >= FRAMES_PER_TURN - FRAMES_USED:
			least[picture] = minf(
				least[picture], RenderingServer.viewport_get_measured_render_time_gpu(_viewport)
			)
			counts[picture] += 1
