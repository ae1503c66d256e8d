# SPDX-License-Identifier: MIT
class_name ShotEffects
extends RefCounted
## Which effects of light near the hole a shot shows, read from its "effects".

## Effects that can be switched off alone; the sky's properties have the same names after "effect_".
const SWITCHES: PackedStringArray = [
	"deflection",
	"aberration",
	"gravitational_shift",
	"doppler",
	"magnification",
	"higher_orders",
]

var off: PackedStringArray = []
var redshift_map: bool = false
## 0: grey, 1: colours as they are.
var saturation: float = 1.0


## Reads what the schema has passed.
static func from_data(data: Dictionary) -> ShotEffects:
	var effects := ShotEffects.new()
	for switch in SWITCHES:
		if not data.get(switch, true):
			effects.off.append(switch)
	effects.redshift_map = data.get("redshift_map", effects.redshift_map)
	effects.saturation = data.get("saturation", effects.saturation)
	return effects


func apply_to(sky: BlackHoleSky) -> void:
	for switch in SWITCHES:
		sky.set("effect_" + switch, not off.has(switch))
	sky.redshift_map = redshift_map
	sky.saturation = saturation
