# SPDX-License-Identifier: MIT
class_name QualityRung
extends Resource
## What the picture may cost at most: one rung of a QualityLadder. Where a visitor has chosen less
## than a rung allows, that stays.

## Images of each star, 1 to 4.
@export_range(1, 4) var image_orders: int = 4
## Stars fainter than this are left out, V magnitudes.
@export_range(-2.0, 99.0, 0.1, "suffix:mag") var magnitude_limit: float = 99.0
## Stars are plain spots, without diffraction or glare.
@export var plain_stars: bool = false
## Images of the disk, 1 to 4.
@export_range(1, 4) var disk_orders: int = 4
## Pixels along each side of the headset's picture, in parts of what it asks for.
@export_range(0.4, 1.0, 0.01) var render_scale: float = 1.0


static func make(orders: int, faintest: float, plain: bool, disk: int, scale: float) -> QualityRung:
	var rung := QualityRung.new()
	rung.image_orders = orders
	rung.magnitude_limit = faintest
	rung.plain_stars = plain
	rung.disk_orders = disk
	rung.render_scale = scale
	return rung
