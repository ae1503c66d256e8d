# SPDX-License-Identifier: MIT
class_name ObserverKind
extends RefCounted
## The kinds of observers by name, and why one cannot be.

enum Kind { STATIC, RAIN, DROPPED, FALLING, RISING, ORBIT_RIGHT, ORBIT_LEFT }


## Who moves so, for the panel.
static func title(kind: Kind) -> String:
	match kind:
		Kind.STATIC:
			return _translated("Static, hovering")
		Kind.RAIN:
			return _translated("Rain, falling from infinity")
		Kind.DROPPED:
			return _translated("Dropped from rest here")
		Kind.FALLING:
			return _translated("Falling, energy below")
		Kind.RISING:
			return _translated("Rising, energy below")
		Kind.ORBIT_RIGHT:
			return _translated("Circular orbit to the right")
	return _translated("Circular orbit to the left")


## Why nobody moves so at a radius, in Schwarzschild radii; `energy` is that of who falls or rises.
static func refusal(kind: Kind, radius: float, energy: float) -> String:
	match kind:
		Kind.STATIC:
			return _translated("Nothing can hover at or inside the horizon.")
		Kind.DROPPED when radius > 1.0:
			return _translated("Who was dropped nearer to the hole never comes here.")
		Kind.DROPPED:
			return _translated("Nothing is at rest at or inside the horizon.")
		Kind.FALLING:
			return _too_weak(energy)
		Kind.RISING when radius > 1.0:
			return _too_weak(energy)
		Kind.RISING:
			return _translated("Nothing moves outward at or inside the horizon.")
		Kind.ORBIT_RIGHT, Kind.ORBIT_LEFT:
			return _translated("There is no circular orbit here: it takes more than 1.5 rₛ.")
	return ""


static func _too_weak(energy: float) -> String:
	var top := 1.0 / (1.0 - energy * energy) if energy < 1.0 else INF
	return (
		_translated("With an energy of %s nothing comes farther out than %s.")
		% [ReadoutText.significant(energy), ReadoutText.distance(top)]
	)


static func _translated(text: String) -> String:
	return TranslationServer.translate(text)
