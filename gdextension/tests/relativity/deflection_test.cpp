// SPDX-License-Identifier: MIT
#include "core/relativity/deflection.h"

#include "core/relativity/critical.h"
#include "core/relativity/orbital_angle.h"
#include "relativity/brute_force_geodesic.h"
#include "relativity/reference_data.h"

#include <cmath>
#include <numbers>

namespace blackhole::test {
namespace {

using std::numbers::pi;

TEST(Deflection, JoinsSeriesAndIntegral) {
	// The series takes over beyond b = 10; both are exact there.
	const double below = deflection(10.0).alpha;
	const double above = deflection(std::nextafter(10.0, 11.0)).alpha;
	EXPECT_LT(relative_error(above, below), 1e-14);
}

TEST(Deflection, HasTheWeakAndStrongLimits) {
	EXPECT_LT(relative_error(deflection(1e8).alpha, 2e-8 + 15.0 * pi / 16.0 * 1e-16), 1e-15);
	const Deflection strong = deflection(kCriticalB * (1.0 + 1e-12));
	EXPECT_NEAR(strong.alpha, strong.alpha_strong, 1e-10);
	EXPECT_NEAR(strong.r_min, 1.5, 1e-5);
}

TEST(Deflection, EqualsBruteForce) {
	// A far static observer looks along a ray with impact parameter b: its angle beyond pi - xi is the
	// deflection, less the part beyond the observer.
	for (const double b : {2.7, 3.0, 5.0, 9.0, 11.0, 30.0}) {
		const double u = 0.02; // r = 50
		const double xi = std::asin(b * u * std::sqrt(1.0 - u));
		const TracedRay in = trace_from_static(u, xi);
		const TracedRay out = trace_from_static(u, pi - xi);
		ASSERT_FALSE(in.captured || out.captured);
		const Deflection found = deflection(b);
		EXPECT_NEAR(found.alpha, in.phi + out.phi - pi, 1e-11) << b;
		EXPECT_NEAR(found.r_min, 1.0 / in.largest_u, 1e-3 * found.r_min) << b;
	}
}

TEST(Deflection, IsNoNumberForCapturedRays) {
	const Deflection captured = deflection(2.5);
	EXPECT_TRUE(std::isnan(captured.alpha));
	EXPECT_TRUE(std::isnan(captured.r_min));
	EXPECT_LT(captured.beyond_critical, 0.0);
	EXPECT_TRUE(std::isnan(deflection(0.0).alpha_weak));
}

TEST(TurningPoint, AgreesWithTheReferenceAngles) {
	const ReferenceData data("u_of_eta");
	const auto a2 = data.column("a2");
	const auto apsis = data.column("eta_apsis");
	const auto horizon = data.column("eta_horizon");
	for (std::size_t i = 0; i < data.size(); ++i) {
		const double a = std::sqrt(a2[i]);
		const double epsilon = 4.0 / 27.0 - a2[i];
		// a2 is rounded: the angle changes by its rounding over epsilon.
		const double tolerance = 2e-15 + 1e-16 / std::abs(epsilon);
		if (!std::isnan(apsis[i])) {
			EXPECT_NEAR(angle_to_turning_point(a, epsilon), apsis[i], tolerance * 10.0) << a2[i];
		} else {
			// At the horizon sigma = 2a, so y = 2 (a - a_c).
			const double y = -2.0 * epsilon / (a + kCriticalA);
			EXPECT_NEAR(orbital_angle(1.0, y), horizon[i], tolerance * 10.0) << a2[i];
		}
	}
}

} // namespace
} // namespace blackhole::test
