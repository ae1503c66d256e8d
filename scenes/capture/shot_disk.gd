# SPDX-License-Identifier: MIT
class_name ShotDisk
extends RefCounted
## The accretion disk of a shot, read from its "disk".

## In the order of AccretionDisk.Look.
const LOOKS: PackedStringArray = [
	"physical", "turbulent", "checkerboard", "temperature", "redshift", "rings"
]
## Keys that are a property of AccretionDisk, by the property's name.
const PROPERTIES: Dictionary[String, String] = {
	"outer_radius_rs": "outer_radius",
	"outer_fade": "outer_fade",
	"retrograde": "retrograde",
	"plunging_gas": "plunging_gas",
	"plunging_temperature": "plunging_temperature",
	"peak_temperature_k": "peak_temperature",
	"accretion_rate_solar_per_year": "accretion_rate",
	"brightness_ev": "brightness_ev",
	"opacity": "opacity",
	"limb_darkening": "limb_darkening",
	"orders": "orders",
	"turbulence": "turbulence",
	"eddy_lifetime": "eddy_lifetime",
	"checker_sectors": "checker_sectors",
	"checker_ring_width_rs": "checker_ring_width",
	"ring_radii_rs": "ring_radii",
	"ring_highlight": "ring_highlight",
	"ring_width_px": "ring_width",
	"time": "time",
}

## The disk's normal, a unit vector.
var normal := Vector3.UP
## How far the disk's pattern is turned about it, in degrees.
var turn_deg: float = 0.0
## How much time of the disk, in r_s/c, passes in a second of a sequence.
var time_per_second: float = 10.0
## Mass of the hole in solar masses, by which an accretion rate heats the disk.
var mass_solar: float = 10.0
## Values of AccretionDisk's properties.
var values: Dictionary[String, Variant] = {}


## Reads what the schema has passed; null for no disk.
static func from_data(data: Variant) -> ShotDisk:
	if data == null or data is bool and not data:
		return null
	var keys: Dictionary = data if data is Dictionary else {}
	var disk := ShotDisk.new()
	for key: String in PROPERTIES:
		var property := PROPERTIES[key]
		disk.values[property] = ClassDB.class_get_property_default_value("AccretionDisk", property)
	disk.values.merge(DiskPresets.values(keys.get("preset", DiskPresets.DEFAULT)), true)
	for key: String in PROPERTIES:
		if keys.has(key):
			disk.values[PROPERTIES[key]] = keys[key]
	if keys.has("look"):
		disk.values["look"] = LOOKS.find(keys["look"])
	disk.time_per_second = keys.get("time_per_second", disk.time_per_second)
	disk.mass_solar = keys.get("mass_solar", disk.mass_solar)
	disk.turn_deg = keys.get("turn_deg", disk.turn_deg)
	if keys.has("normal"):
		disk.normal = Vec3D.to_vector3(Vec3D.normalized(keys["normal"]))
	return disk


## Dresses a disk as it is `seconds` into a sequence.
func apply_to(disk: AccretionDisk, seconds: float = 0.0) -> void:
	disk.basis = untwisted(normal) * Basis(Vector3.UP, deg_to_rad(turn_deg))
	for property: String in values:
		disk.set(property, values[property])
	disk.time = values.get("time", 0.0) + time_per_second * seconds


## Axes of a disk with a normal, a unit vector, whose pattern is not turned.
static func untwisted(upward: Vector3) -> Basis:
	return Basis(Quaternion(Vector3.UP, upward))
