# SPDX-License-Identifier: MIT
class_name ShotHeadset
extends RefCounted
## How large the hole is for a headset's eyes, read from a shot's "xr".

## Metres. Eyes are some 63 mm apart.
var schwarzschild_radius_m: float = 0.3
## How far apart they are for the bending of light, in parts of the truth.
var stereo_baseline_scale: float = 1.0


## Reads what the schema has passed; null for a picture that no headset takes.
static func from_data(data: Variant) -> ShotHeadset:
	if data is bool and not data:
		return null
	var keys: Dictionary = data if data is Dictionary else {}
	var headset := ShotHeadset.new()
	headset.schwarzschild_radius_m = keys.get(
		"schwarzschild_radius_m", headset.schwarzschild_radius_m
	)
	headset.stereo_baseline_scale = keys.get("stereo_baseline_scale", headset.stereo_baseline_scale)
	return headset
