// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "core/photometry/colour_index.h"

namespace blackhole {
namespace {

TEST(ColourIndex, InverseOfTheBlackBodyColour) {
	const ColourTemperature temperature_of;
	for (double temperature = 1900.0; temperature <= 40000.0; temperature *= 1.013) {
		const double got = temperature_of(black_body_b_minus_v(temperature));
		EXPECT_NEAR(got, temperature, 0.5 + 1e-4 * temperature);
	}
}

TEST(ColourIndex, SiriusKeepsItsObservedColour) {
	EXPECT_NEAR(ColourTemperature()(0.009), 12800.0, 50.0);
	EXPECT_NEAR(ballesteros_temperature(0.009), 10014.3, 0.1);
}

TEST(ColourIndex, ColoursBeyondTheRangeAreClamped) {
	const ColourTemperature temperature_of;
	EXPECT_DOUBLE_EQ(temperature_of(5.46), ColourTemperature::kCoolest);
	EXPECT_DOUBLE_EQ(temperature_of(1e300), ColourTemperature::kCoolest);
	EXPECT_DOUBLE_EQ(temperature_of(-1.0), ColourTemperature::kHottest);
	EXPECT_DOUBLE_EQ(ballesteros_temperature(5.0), ballesteros_temperature(2.0));
	EXPECT_DOUBLE_EQ(ballesteros_temperature(-5.0), ballesteros_temperature(-0.4));
}

TEST(ColourIndex, TheSunByBothWays) {
	// B-V of the Sun 0.653 (Ramirez et al. 2012, ApJ 752, 5): the effective temperature is 5772 K.
	EXPECT_NEAR(ballesteros_temperature(0.653), 5772.0, 50.0);
	EXPECT_NEAR(ColourTemperature()(0.653), 5700.0, 50.0);
}

} // namespace
} // namespace blackhole
