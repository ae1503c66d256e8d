# SPDX-License-Identifier: MIT
extends Node3D
## A catalogue made at run time: stars on the edges of a cube, so that one sees what becomes of
## them.

const STARS_PER_EDGE: int = 100

@onready var _sky: BlackHoleSky = $Sky


func _ready() -> void:
	var directions := PackedVector3Array()
	var magnitudes := PackedFloat32Array()
	var temperatures := PackedFloat32Array()
	for axis in 3:
		for side in 4:
			for i in STARS_PER_EDGE:
				var at := Vector3.ZERO
				at[axis] = remap(i, 0, STARS_PER_EDGE - 1, -1.0, 1.0)
				at[(axis + 1) % 3] = -1.0 if side < 2 else 1.0
				at[(axis + 2) % 3] = -1.0 if side % 2 == 0 else 1.0
				directions.append(at)
				magnitudes.append(0.0)
				# Each axis has its colour: red, white, blue.
				temperatures.append([3000.0, 6500.0, 20000.0][axis])
	var catalogue := StarCatalogue.new()
	if catalogue.set_stars(directions, magnitudes, temperatures) != OK:
		push_error(catalogue.get_error_message())
	_sky.catalogue = catalogue
