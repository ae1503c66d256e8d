# SPDX-License-Identifier: MIT
extends Node3D
## An accretion disk round the hole, seen from a camera that goes slowly round it.

const SECONDS_PER_TURN: float = 60.0

@onready var _disk: AccretionDisk = $Sky/Disk
@onready var _arm: Node3D = $Arm


func _ready() -> void:
	DiskPresets.apply(_disk, "museum")
	_disk.time_scale = 10.0


func _process(delta: float) -> void:
	_arm.rotate_y(TAU / SECONDS_PER_TURN * delta)
