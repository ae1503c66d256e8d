// SPDX-License-Identifier: MIT
#include "core/relativity/clocks.h"

#include "core/relativity/observer.h"
#include "core/relativity/physical_scale.h"
#include "core/relativity/radial_fall.h"
#include "core/relativity/shadow.h"
#include "relativity/reference_data.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <limits>

namespace blackhole::test {
namespace {

const glm::dvec3 kOutward = glm::normalize(glm::dvec3(1.0, -2.0, 0.5));

TEST(FarClocks, StraightBackHaveTheRadialObserversRates) {
	for (const double r : {0.05, 1.0, 1.2, 30.0}) {
		const glm::dvec3 place = r * kOutward;
		const double u = 1.0 / r;
		EXPECT_LT(relative_error(
						  *far_clock_rate_outward(place, glm::dvec3(0.0)).value, 1.0 / (1.0 + std::sqrt(u))),
				1e-14);
		for (const double energy : {0.99, 1.0, 3.0}) {
			const glm::dvec3 celerity = *RadialFall::with_energy(energy).value->celerity(place).value;
			const double expected = 1.0 / infall_kappa(u, energy);
			EXPECT_LT(relative_error(*far_clock_rate_outward(place, celerity).value, expected), 1e-13);
			EXPECT_LT(
					relative_error(*far_clock_rate(place, celerity, 2.0 * kOutward).value, expected), 1e-13);
		}
		if (u < 1.0) {
			const glm::dvec3 celerity = *observer_celerity(ObserverMotion::kStatic, place).value;
			EXPECT_LT(
					relative_error(*far_clock_rate_outward(place, celerity).value, 1.0 / std::sqrt(1.0 - u)),
					1e-13);
		}
	}
}

TEST(FarClocks, OfStaticObserversTickAlikeInAllDirections) {
	const double r = 4.0;
	const glm::dvec3 place = r * kOutward;
	const glm::dvec3 celerity = *observer_celerity(ObserverMotion::kStatic, place).value;
	for (const glm::dvec3 &direction : {kOutward, glm::dvec3(0.0, 0.0, 1.0), glm::dvec3(-1.0, 0.0, 1.0)}) {
		EXPECT_LT(relative_error(
						  *far_clock_rate(place, celerity, direction).value, 1.0 / std::sqrt(1.0 - 1.0 / r)),
				1e-13);
	}
}

TEST(FarClocks, OfRainAreFastAheadAndSlowBehind) {
	// 1/(1 - sqrt(u) cos xi) outside of the shadow
	const glm::dvec3 place(0.0, 4.0, 0.0);
	const double xi = shadow_half_angle(0.25, ObserverMotion::kRain);
	for (const double angle : {1.01 * xi, 1.0, 2.0, 3.0}) {
		const glm::dvec3 direction(std::sin(angle), -std::cos(angle), 0.0);
		EXPECT_LT(relative_error(*far_clock_rate(place, glm::dvec3(0.0), direction).value,
						  1.0 / (1.0 - 0.5 * std::cos(angle))),
				1e-13);
	}
	const auto hidden = far_clock_rate(place, glm::dvec3(0.0), glm::dvec3(0.0, -1.0, 0.0));
	EXPECT_NE(hidden.error.find("shadow"), std::string::npos);
}

TEST(FarClocks, RefuseNonsense) {
	const double nan = std::numeric_limits<double>::quiet_NaN();
	EXPECT_FALSE(far_clock_rate(glm::dvec3(0.0), glm::dvec3(0.0), kOutward));
	EXPECT_FALSE(far_clock_rate(kOutward, glm::dvec3(nan, 0.0, 0.0), kOutward));
	EXPECT_FALSE(far_clock_rate(kOutward, glm::dvec3(0.0), glm::dvec3(0.0)));
	EXPECT_FALSE(far_clock_rate_outward(glm::dvec3(nan, 0.0, 0.0), glm::dvec3(0.0)));
	EXPECT_FALSE(far_clock_rate_outward(kOutward, glm::dvec3(nan, 0.0, 0.0)));
}

TEST(PhysicalScale, OfTheSunAndOfSagittariusA) {
	const PhysicalScale sun = *PhysicalScale::of_mass(1.0).value;
	// G M_sun/c^2 = 1.476625038 km, as the IAU's nominal value gives it
	EXPECT_LT(relative_error(sun.metres(), 2.0 * 1476.625038), 1e-9);
	EXPECT_LT(relative_error(sun.seconds() * kSpeedOfLight, sun.metres()), 1e-15);
	// Going with an acceleration of c^2/r_s for r_s/c means sinh(1) c.
	EXPECT_LT(relative_error(sun.standard_gravities() * kStandardGravity * sun.seconds(), kSpeedOfLight),
			1e-15);
	const PhysicalScale heavy = *PhysicalScale::of_mass(4.3e6).value;
	EXPECT_LT(relative_error(heavy.metres(), 4.3e6 * sun.metres()), 1e-15);
	EXPECT_LT(relative_error(heavy.standard_gravities() * 4.3e6, sun.standard_gravities()), 1e-15);
	for (const double mass :
			{0.0, -1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
		EXPECT_FALSE(PhysicalScale::of_mass(mass));
	}
}

} // namespace
} // namespace blackhole::test
