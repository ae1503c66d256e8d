# SPDX-License-Identifier: MIT
class_name RedshiftLegend
extends PanelContainer
## What the colours of the redshift map mean: shown while the map is.

@export var sky: BlackHoleSky


func _process(_delta: float) -> void:
	visible = sky.redshift_map
