# SPDX-License-Identifier: MIT
class_name ScaleTimes
extends RefCounted
## What a catalogue of millions costs: loading, memory, and drawing compared with the built-in one.

const LOADS: int = 3
const TURNS: int = 3
## A measured time belongs to a frame some frames back: a turn's first frames still report the other
## sky.
const FRAMES_PER_TURN: int = 6
const FRAMES_USED: int = 2
## Two orders are the default; memory is told for all there are.
const MOST_ORDERS: int = 4


## Loads the file, draws it beside the stage's own catalogue and returns the figures, by name.
static func measure(stage: BenchStage, file: String) -> Dictionary:
	var catalogue := StarCatalogue.new()
	var load_ms := INF
	for i in LOADS:
		var load_start := Time.get_ticks_usec()
		if catalogue.load_file(file) != OK:
			return {}
		load_ms = minf(load_ms, (Time.get_ticks_usec() - load_start) / 1000.0)
	stage.show_picture(BenchStage.Picture.LENSED_STARS_2)
	var few := stage.sky
	var many := few.duplicate() as BlackHoleSky
	var start := Time.get_ticks_usec()
	many.catalogue = catalogue
	var set_ms := (Time.get_ticks_usec() - start) / 1000.0
	stage.viewport.add_child(many)
	var ratio := await _cost_ratio(stage.viewport, few, many)
	stage.viewport.render_target_update_mode = SubViewport.UPDATE_DISABLED
	many.image_orders = MOST_ORDERS
	await RenderingServer.frame_post_draw
	var stars := catalogue.get_star_count()
	var bytes := float(many.get_star_buffer_bytes()) / stars
	many.free()
	few.visible = true
	stage.viewport.render_target_update_mode = SubViewport.UPDATE_ALWAYS
	var times_as_many := float(stars) / few.catalogue.get_star_count()
	return {
		"stars_2500k_load_ms": load_ms,
		"stars_2500k_set_ms": set_ms,
		"stars_2500k_bytes_per_star": bytes,
		"stars_2500k_to_linear": ratio / times_as_many,
	}


## How much longer drawing `many` takes than drawing `few`: of the least times, in turns.
static func _cost_ratio(viewport: SubViewport, few: BlackHoleSky, many: BlackHoleSky) -> float:
	var seen := viewport.get_viewport_rid()
	RenderingServer.viewport_set_measure_render_time(seen, true)
	var least: PackedFloat64Array = [INF, INF, INF]
	for turn in TURNS:
		for shown in 3:  # neither, few, many
			few.visible = shown == 1
			many.visible = shown == 2
			for frame in FRAMES_PER_TURN:
				await RenderingServer.frame_post_draw
				if frame >= FRAMES_PER_TURN - FRAMES_USED:
					var took := RenderingServer.viewport_get_measured_render_time_gpu(seen)
					least[shown] = minf(least[shown], took)
	return (least[2] - least[0]) / maxf(least[1] - least[0], 1e-6)
