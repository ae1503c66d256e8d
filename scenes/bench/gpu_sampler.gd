# SPDX-License-Identifier: MIT
class_name GpuSampler
extends RefCounted
## Times how long the graphics device draws each of several pictures, in short turns: a round draws
## every picture once, so that what slows the machine for a while slows the whole round. A turn's
## time is the least of its frames. Pictures are to be compared within rounds.

## A measured time belongs to a frame some frames back: a turn's first frames still report the
## previous picture. On a fast card in OpenGL those were more than four.
const FRAMES_PER_TURN: int = 8
const FRAMES_PER_TURN_IN_OPENGL: int = 16
const FRAMES_USED: int = 4
const ROUNDS: int = 40
## So long may the turns of one slow picture take together, milliseconds; it then has fewer.
const SLOW_PICTURE_MS: float = 60000.0

var _stage: BenchStage
var _viewport: RID
var _frames: int = FRAMES_PER_TURN
## Of each picture: the times of its turns, milliseconds, by round.
var _turns: Array[PackedFloat64Array] = []


func _init(stage: BenchStage) -> void:
	_stage = stage
	_viewport = stage.viewport.get_viewport_rid()
	RenderingServer.viewport_set_measure_render_time(_viewport, true)
	_turns.resize(BenchStage.Picture.size())
	if RenderingServer.get_current_rendering_method() == "gl_compatibility":
		_frames = FRAMES_PER_TURN_IN_OPENGL


## Draws `pictures` in rounds.
func measure(pictures: Array[BenchStage.Picture]) -> void:
	for i in ROUNDS:
		for picture in pictures:
			await _take_turn(picture)


## Draws one slow `picture` as often as there is time for, and no more often than the others.
func measure_slow(picture: BenchStage.Picture) -> void:
	for i in ROUNDS:
		await _take_turn(picture)
		var turn_ms := get_least(picture) * _frames
		if (_turns[picture].size() + 1) * turn_ms > SLOW_PICTURE_MS:
			return


## The times of `picture`'s turns, milliseconds, by round.
func get_turns(picture: BenchStage.Picture) -> PackedFloat64Array:
	return _turns[picture]


## The least time of `picture`, milliseconds.
func get_least(picture: BenchStage.Picture) -> float:
	var turns := Array(_turns[picture])
	return turns.min()


func _take_turn(picture: BenchStage.Picture) -> void:
	_stage.show_picture(picture)
	var least := INF
	for frame in _frames:
		await RenderingServer.frame_post_draw
		if frame >= _frames - FRAMES_USED:
			least = minf(least, RenderingServer.viewport_get_measured_render_time_gpu(_viewport))
	_turns[picture].append(least)
