// SPDX-License-Identifier: MIT
#include "core/relativity/circular_orbit.h"

#include "core/relativity/observer.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace blackhole {

Outcome<CircularOrbit> CircularOrbit::through(glm::dvec3 position_rs, glm::dvec3 axis) {
	const Outcome<glm::dvec3> moves = orbit_celerity(position_rs, axis);
	if (!moves) {
		return Outcome<CircularOrbit>::failure(moves.error);
	}
	const double radius = glm::length(position_rs);
	const glm::dvec3 outward = position_rs / radius;
	const glm::dvec3 along = glm::normalize(glm::cross(axis, outward));
	return Outcome<CircularOrbit>::success(CircularOrbit(radius, outward, glm::cross(outward, along)));
}

double CircularOrbit::rain_angular_velocity() const {
	return std::sqrt(0.5 / radius_) / radius_;
}

double CircularOrbit::proper_angular_velocity() const {
	return 1.0 / (radius_ * std::sqrt(2.0 * radius_ - 3.0));
}

double CircularOrbit::energy() const {
	return (radius_ - 1.0) / std::sqrt(radius_ * (radius_ - 1.5));
}

glm::dvec3 CircularOrbit::position_at(double proper_time) const {
	const double angle = proper_angular_velocity() * proper_time;
	return radius_ * (std::cos(angle) * outward_ + std::sin(angle) * glm::cross(axis_, outward_));
}

glm::dvec3 CircularOrbit::celerity_at(double proper_time) const {
	// as orbit_celerity(), which may not refuse a place whose radius rounding has moved
	const glm::dvec3 outward = position_at(proper_time) / radius_;
	return (std::sqrt(2.0) * outward + glm::cross(axis_, outward)) / std::sqrt(2.0 * radius_ - 3.0);
}

double CircularOrbit::rain_time_at(double proper_time) const {
	// dT/dtau = 1/sqrt(1 - 1.5 u)
	return proper_time / std::sqrt((radius_ - 1.5) / radius_);
}

} // namespace blackhole
