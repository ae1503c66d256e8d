# SPDX-License-Identifier: MIT
class_name PictureQuality
extends RefCounted
## What the levels of quality mean for a sky and the viewport that it is drawn in.

## Share of the window's pixels in each direction, images of each star, faintest stars in V
## magnitudes.
const LEVELS: Dictionary[String, Array] = {
	"low": [0.65, 1, 7.0],
	"medium": [1.0, 2, 8.5],
	"high": [1.0, 2, 12.0],
}


static func apply(level: String, sky: BlackHoleSky, viewport: Viewport) -> void:
	var values := LEVELS[level]
	viewport.scaling_3d_scale = values[0]
	sky.image_orders = values[1]
	sky.magnitude_limit = values[2]
