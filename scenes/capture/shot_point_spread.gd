# SPDX-License-Identifier: MIT
class_name ShotPointSpread
extends RefCounted
## How the light of a star spreads on the picture, read from a shot's "psf".

## In the order of BlackHoleSky.PointSpreadModel.
const MODELS: PackedStringArray = ["gaussian", "airy", "eye"]

var model: BlackHoleSky.PointSpreadModel = BlackHoleSky.PSF_GAUSSIAN
var sigma_px: float = 1.0
var aperture_mm: float = 5.0
## Share of the light in the eye's wings; as published.
var glare: float = 0.616


## Reads what the schema has passed.
static func from_data(data: Dictionary) -> ShotPointSpread:
	var spread := ShotPointSpread.new()
	spread.model = MODELS.find(data.get("model", MODELS[0])) as BlackHoleSky.PointSpreadModel
	spread.sigma_px = data.get("sigma_px", spread.sigma_px)
	spread.aperture_mm = data.get("aperture_mm", spread.aperture_mm)
	spread.glare = data.get("glare", spread.glare)
	return spread


func apply_to(sky: BlackHoleSky) -> void:
	sky.psf_model = model
	sky.psf_sigma = sigma_px
	sky.aperture_mm = aperture_mm
	sky.glare = glare
