# SPDX-License-Identifier: MIT
class_name CameraRoll
extends RefCounted
## How far an eye's head is turned to the right: 0 where the celestial north is up in the picture.

## Nearer than this to the pole, the sine of the angle, nothing is up.
const AT_THE_POLE: float = 1e-3


## In degrees, -180 to 180.
static func of(axes: Basis) -> float:
	var north := axes.inverse() * Vector3.UP
	if Vector2(north.x, north.y).length() < AT_THE_POLE:
		return 0.0
	return rad_to_deg(atan2(-north.x, north.y))
