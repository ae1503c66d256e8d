# SPDX-License-Identifier: MIT
class_name ObserverSpeed
extends RefCounted
## The speed that the display shows: relative to the static observer outside the horizon, to rain at
## it and inside.


## Speed in units of c of who moves with `celerity` (velocity times Lorentz factor) relative to rain
## at `place`, in Schwarzschild radii from the hole.
##
## The static observer moves through rain outward with beta = 1/sqrt(r) (Taylor & Wheeler, Exploring
## Black Holes, chapter 7); boosted along it, the celerity's radial part becomes
## (w - beta gamma) / sqrt(1 - beta^2), the part across stays.
static func of(celerity: Vector3, place: Vector3) -> float:
	var radius := place.length()
	if radius <= 1.0:
		return from_celerity(celerity.length())
	var outward := place / radius
	var beta := 1.0 / sqrt(radius)
	var gamma := sqrt(1.0 + celerity.length_squared())
	var radial := celerity.dot(outward)
	var across := (celerity - outward * radial).length()
	return from_celerity(
		Vector2((radial - beta * gamma) / sqrt(1.0 - 1.0 / radius), across).length()
	)


## The speed that belongs to a celerity, both in units of c.
static func from_celerity(celerity: float) -> float:
	return celerity / sqrt(1.0 + celerity * celerity)
