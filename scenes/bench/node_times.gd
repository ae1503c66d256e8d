# SPDX-License-Identifier: MIT
class_name NodeTimes
extends RefCounted
## What the sky node and its catalogue cost the processor.

const LOADS: int = 9
const FRAMES: int = 121
## The eye moves by this angle each frame, so that the node has work in all of them.
const STEP: float = 0.01


## Least time to read the built-in catalogue, milliseconds.
static func catalogue_load_ms() -> float:
	var least := INF
	for i in LOADS:
		var catalogue := StarCatalogue.new()
		var start := Time.get_ticks_usec()
		catalogue.load_file(BenchStage.CATALOGUE_FILE)
		least = minf(least, (Time.get_ticks_usec() - start) / 1000.0)
	return least


## The node's work in a frame, with two image orders and an eye that moves: median and largest,
## milliseconds.
static func update_ms(stage: BenchStage) -> Dictionary:
	stage.show_picture(BenchStage.Picture.LENSED_STARS_2)
	# Only the node's work is wanted, not the picture.
	stage.viewport.render_target_update_mode = SubViewport.UPDATE_DISABLED
	var times := PackedFloat64Array()
	for frame in FRAMES:
		stage.aim(frame * STEP)
		await RenderingServer.frame_post_draw
		if frame > 0:
			times.append(stage.sky.get_update_time_ms())
	stage.viewport.render_target_update_mode = SubViewport.UPDATE_ALWAYS
	stage.aim(0.0)
	times.sort()
	return {
		"node_update_ms": times[floori(times.size() / 2.0)],
		"node_update_largest_ms": times[times.size() - 1],
	}
