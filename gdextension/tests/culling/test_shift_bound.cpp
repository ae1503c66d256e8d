// SPDX-License-Identifier: MIT
#include "core/culling/shift_bound.h"

#include "core/photometry/planck_table.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace blackhole {
namespace {

TEST(ShiftBound, LiesJustAboveTheLargestGain) {
	const PlanckTable planck;
	for (const double coolest : {1500.0, 2500.0, 5000.0}) {
		for (const double hottest : {5000.0, 12000.0, 60000.0}) {
			const ShiftBound bound(coolest, hottest, planck);
			for (double ln_g = -3.99; ln_g < 3.99; ln_g += 0.0137) {
				double largest =
						planck.log2_luminance(std::exp(ln_g) * hottest) - planck.log2_luminance(hottest);
				for (double t = coolest; t <= hottest; t *= 1.05) {
					largest = std::max(
							largest, planck.log2_luminance(std::exp(ln_g) * t) - planck.log2_luminance(t));
				}
				EXPECT_GE(bound.log2_gain(ln_g), largest) << ln_g << ' ' << coolest << ' ' << hottest;
				if (std::abs(ln_g) < 1.0) {
					EXPECT_LT(bound.log2_gain(ln_g), largest + 0.5)
							<< ln_g << ' ' << coolest << ' ' << hottest;
				}
			}
		}
	}
}

TEST(ShiftBound, HasNoLimitForTheGreatestShifts) {
	const ShiftBound bound(3000.0, 9000.0, PlanckTable());
	EXPECT_TRUE(std::isinf(bound.log2_gain(5.0)));
	EXPECT_TRUE(std::isinf(bound.log2_gain(std::nan(""))));
	EXPECT_TRUE(std::isfinite(bound.log2_gain(-20.0)));
}

} // namespace
} // namespace blackhole
