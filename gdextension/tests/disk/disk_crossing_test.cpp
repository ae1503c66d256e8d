// SPDX-License-Identifier: MIT
#include "core/disk/disk_crossing.h"

#include "core/relativity/critical.h"
#include "core/relativity/view_angle.h"
#include "disk/integrated_sight.h"
#include "relativity/reference_data.h"

#include <cmath>
#include <numbers>
#include <random>

// The vectors of the reference are compared by reference_columns_test.cpp.

namespace blackhole::test {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(DiskCrossing, AgreesWithAnIntegratorForObserversAnywhere) {
	std::mt19937_64 random(5);
	const auto uniform = [&random](double low, double high) {
		return std::uniform_real_distribution<double>(low, high)(random);
	};
	int hits = 0;
	int below = 0;
	for (int trial = 0; trial < 100000; ++trial) {
		const double u = std::exp(uniform(std::log(0.01), std::log(10.0)));
		const double xi = uniform(0.02, kPi - 0.02);
		const double y = rain_sigma_offset(u, xi);
		const double sigma = critical_sigma(u) + y;
		const bool inward = sigma * sigma < 1.0 - u;
		if (y <= 0.0 && !(inward && (1.0 - u) / sigma > critical_sigma(u))) {
			continue; // neither end at infinity: see disk_crossing.h
		}
		const DiskSight sight{u, y, uniform(0.0, kPi), uniform(-kPi, kPi)};
		const double chi = first_meeting_angle(sight.inclination, sight.azimuth);
		IntegratedSight integrated(u, slope_from_rain(u, xi));
		for (int order = 0; order < 4; ++order) {
			const double expected = integrated.radius_at(chi + order * kPi);
			const double found = disk_crossing(sight, order).radius;
			if (integrated.margin() < 1e-6) {
				continue; // on the very end: neither is wrong
			}
			ASSERT_EQ(std::isnan(found), std::isnan(expected))
					<< "u " << u << " xi " << xi << " order " << order << " r " << expected << ' ' << found;
			if (!std::isnan(expected)) {
				// Errors of direction grow with exp(chi).
				ASSERT_LT(relative_error(found, expected), 1e-9 * std::exp(kPi * order)) << order;
				++hits;
				below += sight.inclination > 0.5 * kPi ? 1 : 0;
			}
		}
	}
	EXPECT_GT(hits, 30000);
	EXPECT_GT(below, 15000);
}

TEST(DiskRedshift, IsThatOfTheCircularOrbit) {
	// Seen face on: time dilation of the orbit alone.
	EXPECT_DOUBLE_EQ(disk_redshift(6.0, 0.2, 0.0, 1.0), std::sqrt(1.0 - 1.5 / 6.0));
	// Receding to the right of the axis, approaching to the left.
	EXPECT_LT(disk_redshift(6.0, 0.2, 1.4, 1.5), disk_redshift(6.0, 0.2, 1.4, -1.5));
	EXPECT_TRUE(std::isnan(disk_redshift(1.4, 0.2, 1.0, 1.0)));
}

} // namespace
} // namespace blackhole::test
