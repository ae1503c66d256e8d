// SPDX-License-Identifier: MIT
#include "core/relativity/orbital_angle.h"

#include "core/relativity/baseline.h"
#include "core/relativity/carlson.h"
#include "core/relativity/critical.h"
#include "core/relativity/observer.h"
#include "core/relativity/view_angle.h"
#include "relativity/brute_force_geodesic.h"
#include "relativity/reference_data.h"

#include <boost/math/special_functions/ellint_rf.hpp>

#include <cmath>
#include <limits>
#include <numbers>

namespace blackhole::test {
namespace {

using std::numbers::pi;

/// Values of u from 1e-10 to 25, with the photon sphere, the horizon and their close neighbours.
const std::vector<double> &places() {
	static const std::vector<double> all = {1e-10, 1e-7, 1e-4, 0.01, 0.1, 0.3, 0.45, 0.5, 0.6, 0.66, 0.666666,
			2.0 / 3.0, 0.666667, 0.67, 0.7, 0.83, 0.84, 0.99, 1.0 - 1e-9, 1.0, 1.0 + 1e-9, 1.5, 3.0, 10.0,
			25.0};
	return all;
}

TEST(CarlsonPair, EqualsBoostForRealArguments) {
	for (const double x : {1e-8, 0.3, 1.0, 40.0, 1e6}) {
		for (const double y : {1e-12, 0.02, 1.0, 5.0, 1e9}) {
			for (const double z : {1e-3, 0.7, 1.0, 30.0}) {
				const double root_sum = std::sqrt(y) + std::sqrt(z);
				const double found = carlson_rf_pair<double>(x, root_sum * root_sum, std::sqrt(y * z));
				EXPECT_LT(relative_error(found, boost::math::ellint_rf(x, y, z)), 2e-15)
						<< x << " " << y << " " << z;
			}
		}
	}
}

TEST(CarlsonPair, TakesConjugatePairs) {
	// R_F(0, i, -i) and R_F(1/2, 1+i, 1-i)-like values: B. C. Carlson (1995), section 3.
	EXPECT_NEAR(carlson_rf_pair<double>(0.0, 2.0, 1.0), 1.8540746773014, 1e-13);
	EXPECT_NEAR(carlson_rf_pair<double>(2.0, 2.0, 1.0), 1.0441445654064, 1e-13);
}

TEST(OrbitalAngle, EqualsBruteForceForStaticObservers) {
	for (const double u : {1e-4, 0.01, 0.1, 0.3, 0.5, 0.66, 0.7, 0.9, 0.99}) {
		const double kappa = radial_kappa(u, ObserverMotion::kStatic);
		const double edge = 2.0 * std::atan2(critical_sigma(u), kappa);
		for (const double part : {1e-6, 1e-3, 0.05, 0.3, 0.7, 0.99}) {
			const double xi = edge + part * (pi - edge);
			const TracedRay traced = trace_from_static(u, xi);
			ASSERT_FALSE(traced.captured) << u << " " << xi;
			const double y = static_sigma_offset(u, xi);
			const OrbitalAngle found = orbital_angle_slope(u, y);
			// Rounding of xi itself near the edge: |dPhi/dlny| is 1 there, and y is known to 1e-16 sigma_c/y.
			const double tolerance = 1e-11 + 1e-15 / part;
			EXPECT_LT(relative_error(found.phi, traced.phi), tolerance) << "u " << u << " xi " << xi;
		}
		EXPECT_TRUE(trace_from_static(u, edge * (1.0 - 1e-6)).captured) << u;
	}
}

TEST(OrbitalAngle, EqualsBruteForceForRain) {
	for (const double u : {1e-3, 0.1, 0.5, 2.0 / 3.0, 0.8, 1.0, 1.3, 4.0, 10.0, 25.0}) {
		const double edge = 2.0 * std::atan2(critical_sigma(u), 1.0 + std::sqrt(u));
		for (const double part : {1e-6, 1e-3, 0.05, 0.3, 0.7, 0.99}) {
			const double xi = edge + part * (pi - edge);
			const TracedRay traced = trace_from_rain(u, xi);
			ASSERT_FALSE(traced.captured) << u << " " << xi;
			const double found = orbital_angle(u, rain_sigma_offset(u, xi));
			// From deep inside, the integration starts with u'^2 = u^3 + ... of which a^2 is the small rest.
			const double tolerance = 1e-11 + (1e-15 + 1e-16 * u * u) / part;
			EXPECT_LT(relative_error(found, traced.phi), tolerance) << "u " << u << " xi " << xi;
		}
		EXPECT_TRUE(trace_from_rain(u, edge * (1.0 - 1e-6)).captured) << u;
	}
}

TEST(OrbitalAngle, SlopesAreThoseOfDifferences) {
	for (const double u : places()) {
		for (const double phi : {1e-3, 0.5, 2.0, 3.1, 4.0, 7.0, 15.0}) {
			const double y = baseline(baseline_width(u), phi).s0 * 0.8;
			const OrbitalAngle at = orbital_angle_slopes(u, y);
			EXPECT_EQ(at.slope_y, orbital_angle_slope(u, y).slope_y);
			// Five-point differences: h^4 is 1e-12 here, rounding 1e-15/h.
			const auto difference = [](auto f, double step) {
				return (8.0 * (f(step) - f(-step)) - (f(2.0 * step) - f(-2.0 * step))) / (12.0 * step);
			};
			const double by_y = difference([&](double h) { return orbital_angle(u, y + h); }, 1e-3 * y);
			EXPECT_LT(relative_error(at.slope_y, by_y), 1e-9) << "u " << u << " y " << y;
			// sigma_c bends on the scale of |u - 2/3| + y near the photon sphere; keep well inside it.
			const double step = 1e-3 * std::min(u, std::abs(u - 2.0 / 3.0) + y);
			const double by_u = difference([&](double h) { return orbital_angle(u + h, y); }, step);
			EXPECT_NEAR(at.slope_u, by_u, 1e-8 * std::abs(by_u) + 4e-14 * at.phi / step)
					<< "u " << u << " y " << y;
		}
	}
}

TEST(OrbitalAngle, FallsSteadilyWithSigma) {
	for (const double u : places()) {
		double before = std::numeric_limits<double>::infinity();
		for (double log_y = -40.0; log_y < 40.0; log_y += 0.05) {
			const double phi = orbital_angle(u, critical_sigma(u) * std::exp(log_y));
			ASSERT_LT(phi, before) << "u " << u << " ln y " << log_y;
			before = phi;
		}
	}
}

TEST(OrbitalAngle, IsContinuousInU) {
	// Through u = 1/2 and 5/6 (where formulas change), the photon sphere and the horizon, also close to the
	// edge.
	for (const double u : {0.5, 2.0 / 3.0, 5.0 / 6.0, 1.0}) {
		for (const double y : {1e-12, 1e-6, 1e-2, 1.0, 30.0}) {
			const OrbitalAngle at = orbital_angle_slopes(u, y);
			const double h = 1e-5 * y;
			const double below = orbital_angle(u - h, y);
			const double above = orbital_angle(u + h, y);
			EXPECT_NEAR(above - below, 2.0 * h * at.slope_u, 1e-8 * h * std::abs(at.slope_u) + 1e-9 * at.phi)
					<< u << " " << y;
			EXPECT_NEAR(0.5 * (above + below), at.phi, 1e-9 * at.phi) << u << " " << y;
		}
	}
}

TEST(OrbitalAngle, IsSmoothWhereTheOutgoingRayHasTheCriticalImpactParameter) {
	// For u < 2/3 the outgoing ray with a = a_c passes sigma_c'; the roots of the cubic meet there, the angle
	// does not care. Compare with the straight line through neighbours at a distance.
	for (const double u : {1e-4, 0.1, 0.4, 0.6}) {
		const double y = outgoing_critical_sigma(u) - critical_sigma(u);
		const double h = 1e-4 * y;
		const double line = 0.5 * (orbital_angle(u, y - h) + orbital_angle(u, y + h));
		for (const double offset : {-1e-12, -1e-15, 0.0, 1e-15, 1e-12}) {
			const OrbitalAngle at = orbital_angle_slope(u, y * (1.0 + offset));
			EXPECT_LT(relative_error(at.phi, line), 2e-8) << u << " " << offset;
			EXPECT_LT(relative_error(at.slope_y, orbital_angle_slope(u, y - h).slope_y), 1e-3) << u;
			EXPECT_LT(relative_error(at.slope_y, orbital_angle_slope(u, y).slope_y), 1e-9)
					<< u << " " << offset;
		}
	}
}

TEST(OrbitalAngle, ReachesTheEdgeLimit) {
	for (const double u : places()) {
		const double edge = critical_sigma(u);
		const double omega = critical_omega(u);
		const double scale = edge * kEdgeConstant / (omega * (1.0 + omega) * (1.0 + omega));
		// Corrections are of order y ln y over the distance to the photon sphere.
		const double distance = std::min(edge, std::abs(u - kPhotonSphereU) + 1e-300);
		for (const double y : {1e-15 * distance, 1e-100 * edge, 1e-250 * edge}) {
			if (std::abs(u - kPhotonSphereU) < 1e-9) {
				continue; // there the limit has another form
			}
			EXPECT_NEAR(orbital_angle(u, y), std::log(scale / y), 1e-11) << u << " " << y;
		}
	}
}

TEST(OrbitalAngle, ReachesTheFlatLimit) {
	// Far from the hole a ray goes straight: Phi + xi = pi up to the deflection, of order u.
	for (const double u : {1e-10, 1e-8, 1e-6}) {
		for (const double xi : {0.3, 1.0, 2.0, 3.0}) {
			EXPECT_NEAR(orbital_angle(u, static_sigma_offset(u, xi)), pi - xi, 8.0 * u) << u << " " << xi;
		}
	}
}

TEST(OrbitalAngle, RefusesSenselessArguments) {
	for (const double bad :
			{0.0, -1.0, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
		EXPECT_TRUE(std::isnan(orbital_angle(bad, 1.0)));
		EXPECT_TRUE(std::isnan(orbital_angle(1.0, bad)));
		EXPECT_TRUE(std::isnan(orbital_angle_slopes(1.0, bad).slope_u));
	}
}

} // namespace
} // namespace blackhole::test
