// SPDX-License-Identifier: MIT
#pragma once

#include "core/outcome.h"

#include <glm/vec3.hpp>

namespace blackhole {

/// A circular geodesic orbit. Lengths in r_s, times in r_s/c, angles in radians. Frequencies have a relative
/// error of 1e-15 x r/(r - 1.5); places lose what the number of turns takes from the angle.
class CircularOrbit {
public:
	/// The orbit through position_rs (from the hole), right-handed about `axis`, of which only the part
	/// across the position counts. Fails at r <= 1.5 and where axis and position are parallel.
	static Outcome<CircularOrbit> through(glm::dvec3 position_rs, glm::dvec3 axis);

	[[nodiscard]] double radius() const { return radius_; }
	/// Unit normal of its plane.
	[[nodiscard]] const glm::dvec3 &axis() const { return axis_; }
	/// From 3 r_s on; a nudge makes the orbits below it spiral in or leave.
	[[nodiscard]] bool is_stable() const { return radius_ >= 3.0; }

	/// Angle per Painleve-Gullstrand (and Schwarzschild) time: sqrt(u^3/2), Kepler's.
	[[nodiscard]] double rain_angular_velocity() const;
	/// Angle per own time: sqrt(u^3/(2 - 3u)).
	[[nodiscard]] double proper_angular_velocity() const;
	/// Energy per rest mass: (1 - u)/sqrt(1 - 1.5 u).
	[[nodiscard]] double energy() const;

	/// Place at this proper time after the start; any sign.
	[[nodiscard]] glm::dvec3 position_at(double proper_time) const;
	/// Celerity gamma beta relative to the rain frame there.
	[[nodiscard]] glm::dvec3 celerity_at(double proper_time) const;
	/// Painleve-Gullstrand time since the start.
	[[nodiscard]] double rain_time_at(double proper_time) const;

private:
	CircularOrbit(double radius, glm::dvec3 outward, glm::dvec3 axis)
			: radius_(radius), outward_(outward), axis_(axis) {}

	double radius_;
	glm::dvec3 outward_;
	glm::dvec3 axis_;
};

} // namespace blackhole
