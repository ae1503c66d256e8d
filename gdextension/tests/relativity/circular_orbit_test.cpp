// SPDX-License-Identifier: MIT
#include "core/relativity/circular_orbit.h"

#include "core/relativity/observer.h"
#include "core/relativity/world_line.h"
#include "relativity/reference_data.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

namespace blackhole::test {
namespace {

const glm::dvec3 kAxis = glm::normalize(glm::dvec3(1.0, 2.0, 2.0));

TEST(CircularOrbit, GoesRoundInItsPlane) {
	for (const double r : {1.6, 3.0, 10.0, 1e6}) {
		const glm::dvec3 start = glm::normalize(glm::dvec3(2.0, -2.0, 1.0)) * r; // across kAxis
		const CircularOrbit orbit = *CircularOrbit::through(start, 3.0 * kAxis).value;
		EXPECT_LT(glm::length(orbit.axis() - kAxis), 1e-15);
		const double period = 2.0 * std::numbers::pi / orbit.proper_angular_velocity();
		EXPECT_LT(glm::length(orbit.position_at(0.0) - start), 1e-15 * r);
		EXPECT_LT(glm::length(orbit.position_at(period) - start), 1e-14 * r);
		EXPECT_LT(glm::length(orbit.position_at(0.5 * period) + start), 1e-14 * r);
		const glm::dvec3 quarter = orbit.position_at(0.25 * period);
		EXPECT_LT(glm::length(quarter - glm::cross(kAxis, start)), 1e-14 * r); // right-handed
		EXPECT_LT(glm::length(orbit.position_at(-0.25 * period) + quarter), 1e-14 * r);
		EXPECT_LT(
				glm::length(orbit.celerity_at(0.25 * period) - *orbit_celerity(quarter, kAxis).value), 1e-13);
		EXPECT_EQ(orbit.is_stable(), r >= 3.0);
	}
}

TEST(CircularOrbit, CountsOnlyTheAxisAcrossThePosition) {
	const glm::dvec3 start(6.0, 0.0, 0.0);
	const CircularOrbit orbit = *CircularOrbit::through(start, glm::dvec3(0.7, 0.0, 0.1)).value;
	EXPECT_LT(glm::length(orbit.axis() - glm::dvec3(0.0, 0.0, 1.0)), 1e-15);
	EXPECT_LT(glm::length(orbit.celerity_at(0.0) - *orbit_celerity(start, glm::dvec3(0.7, 0.0, 0.1)).value),
			1e-15);
}

TEST(CircularOrbit, HasTheClocksOfItsCelerity) {
	for (const double r : {1.6, 3.0, 20.0}) {
		const CircularOrbit orbit =
				*CircularOrbit::through(glm::dvec3(0.0, r, 0.0), glm::dvec3(1.0, 0.0, 0.0)).value;
		const double w = glm::length(orbit.celerity_at(2.0));
		EXPECT_LT(relative_error(orbit.rain_time_at(7.0), 7.0 * std::sqrt(1.0 + w * w)), 1e-14);
		EXPECT_LT(relative_error(orbit.rain_angular_velocity() * orbit.rain_time_at(1.0),
						  orbit.proper_angular_velocity()),
				1e-14);
		// Kepler's third law with M = 1/2
		EXPECT_LT(relative_error(std::pow(orbit.rain_angular_velocity(), 2) * r * r * r, 0.5), 1e-14);
		EXPECT_LT(relative_error(orbital_energy({orbit.position_at(2.0), orbit.celerity_at(2.0), 0.0, 0.0}),
						  orbit.energy()),
				1e-14);
	}
	// The innermost stable orbit binds 1 - sqrt(8/9).
	const auto innermost = CircularOrbit::through(glm::dvec3(3.0, 0.0, 0.0), glm::dvec3(0.0, 1.0, 0.0));
	EXPECT_NEAR(innermost.value->energy(), std::sqrt(8.0 / 9.0), 1e-15);
}

TEST(CircularOrbit, RefusesByName) {
	EXPECT_NE(CircularOrbit::through(glm::dvec3(1.5, 0.0, 0.0), kAxis).error.find("1.5"), std::string::npos);
	EXPECT_NE(CircularOrbit::through(4.0 * kAxis, kAxis).error.find("axis"), std::string::npos);
	EXPECT_FALSE(CircularOrbit::through(glm::dvec3(4.0, 0.0, 0.0), glm::dvec3(0.0)));
}

} // namespace
} // namespace blackhole::test
