# SPDX-License-Identifier: MIT
@tool
extends RefCounted
## The lines that show an AccretionDisk in the 3D view, by name, in the node's own axes.
##
## A disk lies round its parent's hole wherever its node is; of the node it takes the rotation
## alone.

const CircleLines := preload("circle_lines.gd")

## Radii in Schwarzschild radii: where gas begins to plunge, and how deep plunging gas is drawn.
const INNERMOST_STABLE: float = 3.0
const HORIZON: float = 1.0


## `innermost_stable`, `inner_edge` (where gas plunges) and `outer_edge`, or with the look Rings
## `rings`.
static func of(disk: AccretionDisk) -> Dictionary[StringName, PackedVector3Array]:
	var sky := disk.get_parent() as BlackHoleSky
	var basis := disk.global_basis
	if sky == null or is_zero_approx(basis.determinant()) or not sky.lensing > 0.0:
		return {}
	var radius := sky.schwarzschild_radius * sky.lensing
	var axes := basis.orthonormalized() * Basis.from_scale(Vector3.ONE * radius)
	var frame := disk.global_transform.affine_inverse() * Transform3D(axes, sky.global_position)
	var lines: Dictionary[StringName, PackedVector3Array] = {}
	var radii := radii_of(disk)
	for edge: StringName in radii:
		lines[edge] = PackedVector3Array()
		for ring: float in radii[edge]:
			lines[edge].append_array(frame * CircleLines.circle(ring, Vector3.BACK, Vector3.RIGHT))
	return lines


## The radii of the circles by name, r_s.
static func radii_of(disk: AccretionDisk) -> Dictionary[StringName, PackedFloat32Array]:
	if disk.look == AccretionDisk.LOOK_RINGS:
		return {&"rings": disk.ring_radii}
	var radii: Dictionary[StringName, PackedFloat32Array] = {
		&"innermost_stable": [INNERMOST_STABLE], &"outer_edge": [disk.outer_radius]
	}
	if disk.plunging_gas:
		radii[&"inner_edge"] = [HORIZON]
	return radii
