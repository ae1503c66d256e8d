// SPDX-License-Identifier: MIT
#include "core/relativity/image_direction.h"

#include "core/relativity/critical.h"
#include "core/relativity/einstein_ring.h"
#include "core/relativity/observer.h"
#include "core/relativity/orbital_angle.h"
#include "core/relativity/view_angle.h"
#include "relativity/reference_data.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace blackhole::test {
namespace {

TEST(ImageDirection, InvertsTheOrbitalAngle) {
	for (double log_u = std::log(1e-10); log_u < std::log(25.0); log_u += 0.31) {
		const double u = std::exp(log_u);
		for (double log_phi = std::log(1e-8); log_phi < std::log(300.0); log_phi += 0.17) {
			const double phi = std::exp(log_phi);
			const ImageDirection found = image_direction(u, phi);
			ASSERT_GT(found.y, 0.0) << u << " " << phi;
			const OrbitalAngle angle = orbital_angle_slope(u, found.y);
			ASSERT_LT(relative_error(angle.phi, phi), 4e-15) << u << " " << phi;
			ASSERT_LT(relative_error(found.slope * angle.slope_y, 1.0), 1e-9) << u << " " << phi;
		}
	}
}

TEST(ImageDirection, TendsToTheShadow) {
	for (const double u : {1e-6, 0.2, 1.0, 12.0}) {
		const double omega = critical_omega(u);
		const double factor = critical_sigma(u) * kEdgeConstant / (omega * (1.0 + omega) * (1.0 + omega));
		EXPECT_LT(relative_error(image_direction(u, 40.0).y, factor * std::exp(-40.0)), 1e-12) << u;
	}
}

TEST(ImageDirection, RefusesSenselessArguments) {
	for (const double bad : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
		EXPECT_TRUE(std::isnan(image_direction(bad, 1.0).y));
		EXPECT_TRUE(std::isnan(image_direction(1.0, bad).y));
	}
	EXPECT_TRUE(std::isnan(image_direction(1.0, 301.0).y));
}

TEST(EinsteinRing, HasTheKnownRadiiAtTenRadii) {
	const double kappa = radial_kappa(0.1, ObserverMotion::kStatic);
	const double degrees = 180.0 / std::numbers::pi;
	EXPECT_NEAR(view_angle(0.1, einstein_ring(0.1, 1).y, kappa) * degrees, 29.8283179057, 1e-10);
	EXPECT_NEAR(view_angle(0.1, einstein_ring(0.1, 2).y, kappa) * degrees, 14.6089932189, 1e-10);
	EXPECT_NEAR(view_angle(0.1, einstein_ring(0.1, 3).y, kappa) * degrees, 14.2830912603, 1e-10);
}

} // namespace
} // namespace blackhole::test
