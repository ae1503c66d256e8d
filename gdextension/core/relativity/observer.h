// SPDX-License-Identifier: MIT
#pragma once

#include "core/outcome.h"

#include <glm/vec3.hpp>

namespace blackhole {

/// How an observer moves. Every motion is the local rain frame (free fall from rest at infinity, regular
/// through the horizon, axes = world axes) plus one Lorentz boost.
enum class ObserverMotion {
	/// At rest at its place; exists outside the horizon only.
	kStatic,
	/// Free fall from rest at infinity.
	kRain,
	/// Radial free fall, inward or outward, with a given energy.
	kInfall,
	/// Circular geodesic orbit.
	kOrbit,
	/// A given velocity.
	kVelocity,
};

/// kappa in tan(xi/2) = sigma/kappa, the only thing radial motion changes in the picture: sqrt(1 - u) for
/// static observers (NaN for u >= 1), 1 + sqrt(u) for rain, NaN for motions that need more to be known. u =
/// r_s/r > 0.
double radial_kappa(double u, ObserverMotion motion);

/// kappa of radial free fall inward with energy per rest mass `energy`: eps + sqrt(eps^2 - 1 + u). Rain is
/// eps = 1. NaN where no such motion exists.
double infall_kappa(double u, double energy);

/// kappa of the outward motion with the same energy, eps - sqrt(eps^2 - 1 + u); NaN for u >= 1.
double outgoing_kappa(double u, double energy);

/// Celerity gamma beta, relative to the rain frame, of the radial motion with this kappa at position_rs: such
/// a boost multiplies tan(xi/2) by kappa_rain/kappa. For motions other than those of ObserverMotion.
Outcome<glm::dvec3> radial_celerity(glm::dvec3 position_rs, double kappa);

/// Celerity gamma beta of an observer at position_rs (from the hole, in r_s), relative to the rain frame
/// there, in world axes. Fails for a static observer at or inside the horizon and for a position that is no
/// place.
Outcome<glm::dvec3> observer_celerity(ObserverMotion motion, glm::dvec3 position_rs);

/// Celerity of the circular orbit at position_rs, relative to the rain frame: sqrt(2u/(2-3u)) outward and
/// sqrt(u/(2-3u)) along `axis` x outward. Fails at r <= 1.5 and where axis and position are parallel.
Outcome<glm::dvec3> orbit_celerity(glm::dvec3 position_rs, glm::dvec3 axis);

/// Celerity relative to the rain frame of an observer who has the celerity `relative` in the frame that moves
/// with `frame` relative to rain; the axes of that frame are the rain frame's carried by its boost.
glm::dvec3 composed_celerity(glm::dvec3 frame, glm::dvec3 relative);

/// Aberration: unit direction towards a source in the frame that moves with `celerity`, given the unit
/// direction in the first frame. Exact for every celerity; the inverse is the same function with -celerity.
glm::dvec3 boost_direction(glm::dvec3 toward_source, glm::dvec3 celerity);

/// Doppler factor nu'/nu of that boost. Solid angles of sources change by 1/D^2, frequencies by D. Relative
/// precision is kept when receding at high speed.
double doppler_factor(glm::dvec3 toward_source, glm::dvec3 celerity);

} // namespace blackhole
