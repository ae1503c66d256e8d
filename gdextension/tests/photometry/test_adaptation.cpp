// SPDX-License-Identifier: MIT
#include <cmath>

#include <gtest/gtest.h>

#include "core/photometry/adaptation.h"

namespace blackhole {
namespace {

/// The exposure after so many seconds, in so many steps, from p_from to p_wanted.
double after(double p_seconds, int p_steps, double p_from, double p_wanted, double p_speed = 1.0) {
	Adaptation eye;
	eye.settle(p_from);
	for (int i = 0; i < p_steps; ++i) {
		eye.step(p_wanted, p_seconds / p_steps, p_speed);
	}
	return eye.ev();
}

TEST(Adaptation, TheKeyNeedsNoExposure) {
	EXPECT_EQ(wanted_exposure(kKeyLuminance, {}), 0.0);
	EXPECT_NEAR(wanted_exposure(8.0 * kKeyLuminance, {}), -3.0, 1e-12);
	EXPECT_NEAR(wanted_exposure(0.25 * kKeyLuminance, {}), 2.0, 1e-12);
}

TEST(Adaptation, ExposuresHaveLimits) {
	const ExposureLimits limits{-3.0, 2.0};
	EXPECT_EQ(wanted_exposure(1e9, limits), -3.0);
	EXPECT_EQ(wanted_exposure(1e-30, limits), 2.0);
	EXPECT_EQ(wanted_exposure(0.0, limits), 2.0) << "black";
}

TEST(Adaptation, TheFrameRateMakesNoDifference) {
	for (const double wanted : {-5.0, 3.0}) {
		const double once = after(1.3, 1, 1.0, wanted);
		EXPECT_NEAR(after(1.3, 13, 1.0, wanted), once, 1e-12);
		EXPECT_NEAR(after(1.3, 400, 1.0, wanted), once, 1e-12);
	}
}

TEST(Adaptation, QuickIntoTheLightSlowIntoTheDark) {
	EXPECT_NEAR(after(Adaptation::kLightSeconds, 24, 0.0, -4.0), -4.0 * (1.0 - std::exp(-1.0)), 1e-12);
	EXPECT_NEAR(after(Adaptation::kDarkSeconds, 150, 0.0, 4.0), 4.0 * (1.0 - std::exp(-1.0)), 1e-12);
	EXPECT_LT(Adaptation::kLightSeconds, Adaptation::kDarkSeconds);
}

TEST(Adaptation, SpeedScalesTimeAndZeroIsAtOnce) {
	EXPECT_NEAR(after(0.5, 30, 0.0, 2.0, 3.0), after(1.5, 30, 0.0, 2.0), 1e-12);
	EXPECT_EQ(after(0.0, 1, 0.0, 2.0, 0.0), 2.0);
	EXPECT_EQ(after(0.0, 1, 0.5, 2.0), 0.5) << "no time, no change";
}

} // namespace
} // namespace blackhole
