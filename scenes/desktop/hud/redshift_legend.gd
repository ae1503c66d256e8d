# SPDX-License-Identifier: MIT
class_name RedshiftLegend
extends PanelContainer
## What the colours of the redshift map mean: shown while the map is, or a disk
## in its colours.

@export var sky: BlackHoleSky
@export var disk: AccretionDisk


func _process(_delta: float) -> void:
	var on_disk := disk.visible and disk.look == AccretionDisk.LOOK_REDSHIFT
	visible = sky.redshift_map or on_disk
