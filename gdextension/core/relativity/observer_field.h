// SPDX-License-Identifier: MIT
#pragma once

#include "core/outcome.h"
#include "core/relativity/observer.h"

#include <glm/vec3.hpp>

namespace blackhole {

/// How observers move at every place: a motion and what it needs to be known. A plain ObserverMotion serves
/// where nothing more is needed (static, rain).
struct ObserverField {
	ObserverMotion motion = ObserverMotion::kStatic;
	/// Infall: energy per rest mass, > 0; 1 is rain, below 1 the fall starts from rest at r = 1/(1 -
	/// energy^2).
	double energy = 1.0;
	/// Infall: on the way out.
	bool outgoing = false;
	/// Orbit: the motion is right-handed about this axis.
	glm::dvec3 axis{0.0, 1.0, 0.0};
	/// Velocity: celerity gamma beta in world axes.
	glm::dvec3 celerity{0.0};
	/// Velocity: relative to the static observer rather than to rain.
	bool relative_to_static = false;

	ObserverField() = default;
	ObserverField(ObserverMotion p_motion) : motion(p_motion) {} // NOLINT(google-explicit-constructor)

	bool operator==(const ObserverField &) const = default;
};

/// The energy of a fall from rest at radius r [r_s] > 1: sqrt(1 - 1/r).
double energy_from_rest(double r);

/// An observer at a place: a frame that moves radially, in which tan(xi/2) = sigma/kappa, and one more boost
/// relative to it. Radial motions are all in kappa and lose nothing by rounding; for the others the frame is
/// rain.
struct LocalObserver {
	double u = 0.0;           ///< r_s/r
	glm::dvec3 outward{0.0};  ///< unit vector from the hole
	double kappa = 0.0;       ///< of the radially moving frame
	glm::dvec3 celerity{0.0}; ///< gamma beta relative to that frame, world axes
};

/// The observer of a field at position_rs (from the hole, in r_s). Fails with a reason where there is none:
/// static at or inside the horizon, an energy too small for the place, outward inside the horizon, an orbit
/// at r <= 1.5 or on its axis, numbers that are none.
Outcome<LocalObserver> local_observer(const ObserverField &field, glm::dvec3 position_rs);

/// Celerity of that observer relative to rain: the one boost that carries the world axes into the observer's.
Outcome<glm::dvec3> field_celerity(const ObserverField &field, glm::dvec3 position_rs);

} // namespace blackhole
