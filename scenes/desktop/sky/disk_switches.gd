# SPDX-License-Identifier: MIT
class_name DiskSwitches
extends Node
## What a visitor can switch at the accretion disk: whether it is there, which ready-made one it is,
## and how it lies.

## So much less than by themselves ready-made disks shine here: the exposure is that for faint
## stars.
@export_range(0.0, 10.0, 0.1, "suffix:EV") var dimming: float = 2.5
## Nor do they shine more than so: beside a black body as bright as it is there are no stars.
@export_range(-60.0, 0.0, 0.1, "suffix:EV") var brightest: float = -35.0
@export var disk: AccretionDisk

## Angle of the disk's normal to the first view's line of sight, in degrees: from there 0 is seen
## face on and 90 edge on.
var inclination: float = 84.0:
	set(value):
		inclination = clampf(value, 0.0, 90.0)
		_turn()
## The one of [constant DiskPresets.NAMES] that was chosen last.
var preset: String = DiskPresets.DEFAULT:
	set(value):
		preset = value
		_apply_preset()


func _ready() -> void:
	_apply_preset()
	_turn()


func toggle() -> void:
	disk.visible = not disk.visible


## The next of the ready-made disks, and round again; where none is shown, the present one.
func next_preset() -> void:
	if disk.visible:
		var at := DiskPresets.NAMES.find(preset) + 1
		preset = DiskPresets.NAMES[at % DiskPresets.NAMES.size()]
	disk.show()


func _apply_preset() -> void:
	DiskPresets.apply(disk, preset)
	disk.brightness_ev = minf(disk.brightness_ev - dimming, brightest)


# About the first view's horizontal line: its upper side comes to be seen as the angle shrinks.
func _turn() -> void:
	var rig := ViewRig.new()
	StartView.apply_to(rig)
	var view := Basis(rig.get_orientation())
	disk.basis = view * Basis(Vector3.RIGHT, deg_to_rad(90.0 - inclination))
