// SPDX-License-Identifier: MIT
#include "core/disk/page_thorne.h"
#include "core/tables/lensing_shader.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace blackhole::test {
namespace {

/// What the shader reads at r.
double shader_temperature(double r, double plunging = 0.0) {
	return lensing_shader::disk_temperature_share(static_cast<float>(1.0 / r), static_cast<float>(plunging));
}

/// The temperature at the very radius of which the shader knows.
double exact_temperature(double r) {
	return page_thorne_temperature(1.0 / static_cast<double>(static_cast<float>(1.0 / r)));
}

TEST(DiskTemperature, GivesTheDisksTemperature) {
	const double last = std::log(1e4);
	for (double log_r = std::log(3.001); log_r < last; log_r += 1e-3) {
		const double r = std::exp(log_r);
		// The temperature falls as sqrt(1 - s), s = sqrt(3/r): next to r = 3 the rounding of s counts.
		const double rounding = 3e-8 / (1.0 - std::sqrt(3.0 / r));
		ASSERT_NEAR(shader_temperature(r) / exact_temperature(r), 1.0, 6e-6 + rounding) << "r " << r;
	}
}

TEST(DiskTemperature, EndsAtTheLastStableOrbit) {
	EXPECT_EQ(shader_temperature(3.0), 0.0);
	EXPECT_EQ(shader_temperature(2.0), 0.0);
	EXPECT_EQ(shader_temperature(0.5), 0.0);
}

TEST(DiskTemperature, PlungingGasKeepsItsTemperature) {
	EXPECT_EQ(shader_temperature(0.5, 0.25), 0.25);
	EXPECT_EQ(shader_temperature(3.0, 0.25), 0.25);
	// Nowhere within the hottest ring is it colder; the rest is as it was.
	for (const double r : {3.001, 3.02, 3.2, 4.0, 4.7}) {
		EXPECT_EQ(shader_temperature(r, 0.25), std::max(shader_temperature(r), 0.25)) << "r " << r;
	}
	for (const double r : {5.0, 20.0, 1000.0}) {
		EXPECT_EQ(shader_temperature(r, 0.25), shader_temperature(r)) << "r " << r;
	}
}

} // namespace
} // namespace blackhole::test
