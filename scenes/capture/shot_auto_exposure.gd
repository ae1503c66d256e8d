# SPDX-License-Identifier: MIT
class_name ShotAutoExposure
extends RefCounted
## An exposure that follows the light, read from a shot's "exposure".

var compensation_ev: float = 0.0
var min_ev: float = -10.0
var max_ev: float = 6.0
## 1: the usual pace, 0: at once.
var adaptation_speed: float = 1.0


## Reads what the schema has passed; null for a number, which is a manual exposure.
static func from_data(data: Variant) -> ShotAutoExposure:
	if data is float or data is int:
		return null
	var keys: Dictionary = data if data is Dictionary else {}
	var exposure := ShotAutoExposure.new()
	exposure.compensation_ev = keys.get("compensation_ev", exposure.compensation_ev)
	exposure.min_ev = keys.get("min_ev", exposure.min_ev)
	exposure.max_ev = keys.get("max_ev", exposure.max_ev)
	exposure.adaptation_speed = keys.get("adaptation_speed", exposure.adaptation_speed)
	return exposure


func apply_to(sky: BlackHoleSky) -> void:
	sky.auto_exposure = true
	sky.exposure = compensation_ev
	sky.auto_exposure_min_ev = min_ev
	sky.auto_exposure_max_ev = max_ev
	sky.adaptation_speed = adaptation_speed
