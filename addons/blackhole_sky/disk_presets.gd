# SPDX-License-Identifier: MIT
class_name DiskPresets
extends RefCounted
## Ready-made accretion disks: values for the properties of an AccretionDisk.

const DEFAULT: String = "museum"
const NAMES: PackedStringArray = ["museum", "physicist", "film"]

const _MUSEUM: Dictionary[String, Variant] = {
	"look": AccretionDisk.LOOK_TURBULENT,
	"outer_radius": 15.0,
	"outer_fade": 0.45,
	"plunging_gas": false,
	"peak_temperature": 5600.0,
	"accretion_rate": 0.0,
	"brightness_ev": -35.3,
	"opacity": 0.97,
	"limb_darkening": true,
	"orders": 3,
	"turbulence": 0.8,
	"eddy_lifetime": 90.0,
}
## Nothing but the theory: a bare black-body disk as bright as it is.
const _PHYSICIST: Dictionary[String, Variant] = {
	"look": AccretionDisk.LOOK_PHYSICAL,
	"outer_radius": 15.0,
	"outer_fade": 0.0,
	"plunging_gas": false,
	"peak_temperature": 5600.0,
	"accretion_rate": 0.0,
	"brightness_ev": 0.0,
	"opacity": 1.0,
	"limb_darkening": false,
	"orders": 4,
	"turbulence": 0.0,
	"eddy_lifetime": 90.0,
}
## What a cinema would show of it: wide, thin, glowing to the horizon.
const _FILM: Dictionary[String, Variant] = {
	"look": AccretionDisk.LOOK_TURBULENT,
	"outer_radius": 18.0,
	"outer_fade": 0.7,
	"plunging_gas": true,
	"plunging_temperature": 0.75,
	"peak_temperature": 4300.0,
	"accretion_rate": 0.0,
	"brightness_ev": -33.5,
	"opacity": 0.85,
	"limb_darkening": false,
	"orders": 3,
	"turbulence": 1.2,
	"eddy_lifetime": 120.0,
}


## The properties and values of a preset; empty for a name that is none.
static func values(preset: String) -> Dictionary[String, Variant]:
	match preset:
		"museum":
			return _MUSEUM
		"physicist":
			return _PHYSICIST
		"film":
			return _FILM
	return {}


## Gives a disk the look of a preset.
static func apply(disk: AccretionDisk, preset: String) -> void:
	var chosen := values(preset)
	for property: String in chosen:
		disk.set(property, chosen[property])
