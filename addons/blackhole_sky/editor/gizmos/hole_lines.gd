# SPDX-License-Identifier: MIT
@tool
extends RefCounted
## The lines that show a BlackHoleSky in the 3D view, by name, in the node's own axes.
##
## The layers of the sky take from the node its place and its rotation but not its scale, so these
## lines undo the scale that the engine lays on gizmos.

const CircleLines := preload("circle_lines.gd")
const OrbitLines := preload("orbit_lines.gd")

## Radii in Schwarzschild radii.
const HORIZON: float = 1.0
const PHOTON_SPHERE: float = 1.5
## Half the width of the shadow for an eye far away: the critical impact parameter, 3 sqrt(3)/2.
const SHADOW: float = 2.598076


## `horizon` and `photon_sphere`; `shadow`, to be turned to the camera; `orbit` where observers go
## round.
static func of(sky: BlackHoleSky) -> Dictionary[StringName, PackedVector3Array]:
	var radius := sky.schwarzschild_radius * sky.lensing
	var basis := sky.global_basis
	if not radius > 0.0 or is_zero_approx(basis.determinant()):
		return {}
	var frame := Transform3D(basis.inverse() * basis.orthonormalized(), Vector3.ZERO)
	var lines: Dictionary[StringName, PackedVector3Array] = {
		&"horizon": frame * CircleLines.sphere(HORIZON * radius),
		&"photon_sphere": frame * CircleLines.sphere(PHOTON_SPHERE * radius),
		&"shadow": CircleLines.circle(SHADOW * radius, Vector3.RIGHT, Vector3.UP),
	}
	var orbits := OrbitLines.of(sky, radius)
	if not orbits.is_empty():
		lines[&"orbit"] = frame * orbits
	return lines
