# SPDX-License-Identifier: MIT
class_name SkyAxes
extends RefCounted
## The addon's axes of the sky: x to RA 0h Dec 0, y to the north celestial pole, -z to RA 6h Dec 0.


## The unit vector to a place in degrees.
static func direction(ra_deg: float, dec_deg: float) -> Vector3:
	var ra := deg_to_rad(ra_deg)
	var dec := deg_to_rad(dec_deg)
	return Vector3(cos(dec) * cos(ra), sin(dec), -cos(dec) * sin(ra))


## Whether right ascension lies from 0 to 360 and declination from -90 to 90; false for NaN.
static func is_place(ra_deg: float, dec_deg: float) -> bool:
	return ra_deg >= 0.0 and ra_deg <= 360.0 and dec_deg >= -90.0 and dec_deg <= 90.0
