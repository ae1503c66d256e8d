# SPDX-License-Identifier: MIT
class_name MapDisk
extends RefCounted
## The accretion disk of the map's sky, which does as the picture's does.

## What it does not take over.
const OWN: PackedStringArray = ["brightness_ev", "time_scale"]

var _disk := AccretionDisk.new()
var _shared := SharedProperties.new(&"AccretionDisk", OWN)


## Its sky frees it.
func _init(sky: BlackHoleSky) -> void:
	_disk.visible = false
	sky.add_child(_disk)


## Takes over place and settings; `gain_ev` is what the map is exposed more and the disk is not.
func follow(disk: AccretionDisk, gain_ev: float) -> void:
	_shared.copy(disk, _disk)
	var brightness := disk.brightness_ev - gain_ev
	if _disk.brightness_ev != brightness:
		_disk.brightness_ev = brightness
	if _disk.transform != disk.transform:
		_disk.transform = disk.transform
	if _disk.visible != disk.visible:
		_disk.visible = disk.visible
