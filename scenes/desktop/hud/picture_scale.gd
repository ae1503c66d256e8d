# SPDX-License-Identifier: MIT
class_name PictureScale
extends Node
## Keeps text and stars at the same apparent size whatever the resolution is.

## Height of the window for which sizes are given, in pixels.
const REFERENCE_HEIGHT: float = 720.0
## Standard deviation of a star's sprite at that height and the least that pixels can show, in
## pixels.
const STAR_SIGMA: float = 0.8
const LEAST_SIGMA: float = 0.7
const LARGEST_SCALE: float = 4.0

@export var sky: BlackHoleSky


func _ready() -> void:
	get_window().size_changed.connect(_fit)
	_fit()


func _exit_tree() -> void:
	get_window().size_changed.disconnect(_fit)
	get_window().content_scale_factor = 1.0


## How much larger than at the reference height text is to be, for a window of `size` pixels.
static func text_scale(size: Vector2i) -> float:
	var smaller := minf(size.y, size.x * 9.0 / 16.0)
	return clampf(snappedf(smaller / REFERENCE_HEIGHT, 0.125), 0.75, LARGEST_SCALE)


## The sprites' standard deviation for a picture of `height` pixels.
static func star_sigma(height: float) -> float:
	return maxf(STAR_SIGMA * height / REFERENCE_HEIGHT, LEAST_SIGMA)


func _fit() -> void:
	var size := get_window().size
	get_window().content_scale_factor = text_scale(size)
	sky.psf_sigma = star_sigma(size.y)
