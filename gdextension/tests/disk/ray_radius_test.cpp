// SPDX-License-Identifier: MIT
#include "core/disk/ray_radius.h"

#include "core/relativity/critical.h"
#include "relativity/reference_data.h"

#include <cmath>

namespace blackhole::test {
namespace {

TEST(RayRadius, AgreesWithTheReference) {
	const ReferenceData data("u_of_eta");
	const auto a2 = data.column("a2");
	const auto eta = data.column("eta");
	const auto u = data.column("u");
	const auto apsis = data.column("eta_apsis");
	for (std::size_t i = 0; i < data.size(); ++i) {
		// 4/27 - a^2 to the precision of the given a^2.
		const double epsilon = 4.0 / 27.0 - a2[i];
		// Beyond the turning point the way out is the way in once more.
		const double way = eta[i] > apsis[i] ? 2.0 * apsis[i] - eta[i] : eta[i];
		const double found = inverse_radius_on_ray(std::sqrt(a2[i]), epsilon, way, 1e3);
		// Near the critical ray a^2 itself, as a double, says no more.
		const double tolerance = 1e-13 + 1e-15 / std::abs(epsilon);
		EXPECT_NEAR(found, u[i], tolerance) << "row " << i;
	}
}

TEST(RayRadius, EndsAtTurningPointAndHorizon) {
	const ReferenceData data("u_of_eta");
	const auto a2 = data.column("a2");
	const auto apsis = data.column("eta_apsis");
	const auto horizon = data.column("eta_horizon");
	int seen = 0;
	for (std::size_t i = 0; i < data.size(); ++i) {
		const double epsilon = 4.0 / 27.0 - a2[i];
		const bool turns = epsilon > 0.0;
		if (std::abs(epsilon) < 1e-6) {
			continue;
		}
		const double end = turns ? apsis[i] : horizon[i];
		const double a = std::sqrt(a2[i]);
		EXPECT_TRUE(std::isnan(inverse_radius_on_ray(a, epsilon, end + 1e-8, 1.0)));
		const double last = inverse_radius_on_ray(a, epsilon, end - 1e-8, 1.0);
		EXPECT_TRUE(turns ? last < kPhotonSphereU : std::abs(last - 1.0) < 1e-6) << "row " << i;
		// Deeper than the horizon, for who is there to see it.
		if (!turns) {
			EXPECT_GT(inverse_radius_on_ray(a, epsilon, end + 1e-8, 10.0), 1.0);
		}
		++seen;
	}
	EXPECT_GT(seen, 200);
}

TEST(RayRadius, RefusesWhatIsNoRay) {
	EXPECT_TRUE(std::isnan(inverse_radius_on_ray(0.1, 4.0 / 27.0 - 0.01, 0.0, 1.0)));
	EXPECT_TRUE(std::isnan(inverse_radius_on_ray(0.0, 4.0 / 27.0, 1.0, 1.0)));
	EXPECT_TRUE(std::isnan(inverse_radius_on_ray(0.1, 4.0 / 27.0 - 0.01, std::nan(""), 1.0)));
}

} // namespace
} // namespace blackhole::test
