// SPDX-License-Identifier: MIT
#pragma once

#include "core/outcome.h"
#include "core/relativity/observer_field.h"

#include <glm/vec3.hpp>

namespace blackhole {

/// A disk's plane through the hole and the sense in which its gas turns.
struct DiskPlane {
	glm::dvec3 normal{0.0, 1.0, 0.0}; ///< any length but zero
	bool retrograde = false;          ///< the gas turns left-handedly about it
};

/// The point of the plane that is seen in a direction.
struct DiskPoint {
	/// False where the line of sight does not come so far; then the rest is meaningless.
	bool reached = false;
	double radius = 0.0;   ///< r_s
	glm::dvec3 place{0.0}; ///< unit vector from the hole
	/// nu_observed/nu_emitted of gas on the circular orbit there or, within r = 3 r_s, of plunging gas.
	double redshift = 1.0;
};

/// The (order + 1)-th point where the line of sight in `view_direction` (the observer's own frame, any
/// length), followed backwards from position_rs (from the hole, r_s), meets the plane; exact. Fails where the
/// motion does not exist and for senseless arguments.
Outcome<DiskPoint> seen_disk_point(glm::dvec3 position_rs, glm::dvec3 view_direction, const DiskPlane &plane,
		int order, const ObserverField &observer);

/// A meeting of a line of sight with a plane through the hole.
struct PlaneCrossing {
	bool reached = false;     ///< false where there is none; then the rest is meaningless
	double radius = 0.0;      ///< r_s
	glm::dvec3 position{0.0}; ///< from the hole, r_s
};

/// The same for a plane without a disk. For an observer on the plane his own place is none of the meetings;
/// a line of sight that lies in the plane has none.
Outcome<PlaneCrossing> plane_crossing(glm::dvec3 position_rs, glm::dvec3 view_direction, glm::dvec3 normal,
		int order, const ObserverField &observer);

} // namespace blackhole
