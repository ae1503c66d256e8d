// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "core/photometry/planck.h"

namespace blackhole {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

struct Known {
	double temperature, x, y, log10_luminance;
};

// Published colours of black bodies (CIE 1931 2-degree observer, c2 = 1.438776877e-2 m K).
constexpr Known kKnown[] = {
		{3000.0, 0.436931, 0.404074, 7.4803},
		{5772.0, 0.326553, 0.335834, 9.2657},
		{6504.0, 0.313464, 0.323568, 9.4886},
		{10000.0, 0.280634, 0.288288, 10.1226},
};

TEST(Planck, KnownColoursAndLuminances) {
	for (const Known &known : kKnown) {
		const glm::dvec2 xy = planck_chromaticity(known.temperature);
		EXPECT_NEAR(xy.x, known.x, 5.1e-7) << known.temperature << " K";
		EXPECT_NEAR(xy.y, known.y, 5.1e-7) << known.temperature << " K";
		EXPECT_NEAR(planck_luminance_log10(known.temperature), known.log10_luminance, 5.1e-5);
	}
}

TEST(Planck, InfiniteTemperature) {
	const glm::dvec2 xy = planck_chromaticity(kInfinite);
	EXPECT_NEAR(xy.x, 0.239877, 5.1e-7);
	EXPECT_NEAR(xy.y, 0.234037, 5.1e-7);
	EXPECT_EQ(planck_luminance_log10(kInfinite), kInfinite);
	EXPECT_LT(glm::distance(planck_rgb(1e9), planck_rgb(kInfinite)), 1e-4);
	EXPECT_NEAR(planck_luminance_log10(1e12) - planck_luminance_log10(1e11), 1.0, 1e-6) << "Y goes as T";
}

TEST(Planck, LowTemperaturesAreFiniteAndDark) {
	double before = -kInfinite;
	for (const double temperature : {10.0, 30.0, 100.0, 300.0, 500.0, 800.0}) {
		const double log10_y = planck_luminance_log10(temperature);
		EXPECT_TRUE(std::isfinite(log10_y));
		EXPECT_GT(log10_y, before);
		before = log10_y;
	}
	// Wien's tail: d ln Y/d(1/T) = -c2/lambda_eff, the effective wavelength moving to the red end of the
	// table.
	const double slope = std::log(10.0) * (planck_luminance_log10(101.0) - planck_luminance_log10(100.0)) /
			(1.0 / 101.0 - 1.0 / 100.0);
	EXPECT_GT(1.438776877e-2 / -slope, 700e-9);
	EXPECT_LT(1.438776877e-2 / -slope, 830e-9);
}

TEST(Planck, RgbHasLuminanceOneAndStaysInGamut) {
	for (double temperature = 100.0; temperature < 1e8; temperature *= 1.1) {
		const glm::dvec3 rgb = planck_rgb(temperature);
		EXPECT_NEAR(glm::dot(rgb, kLuminanceWeights), 1.0, 1e-12) << temperature << " K";
		EXPECT_GE(std::min({rgb.x, rgb.y, rgb.z}), 0.0) << temperature << " K";
	}
}

TEST(Planck, LeavesTheGamutAt1900Kelvin) {
	EXPECT_GT(planck_rgb(1905.0).z, 0.0);
	EXPECT_EQ(planck_rgb(1895.0).z, 0.0);
	const glm::dvec3 white = planck_rgb(6504.0);
	EXPECT_NEAR(white.x, 1.0, 0.05);
	EXPECT_NEAR(white.z, 1.0, 0.05);
}

TEST(Planck, DesaturationKeepsLuminance) {
	const glm::dvec3 inside(0.5, 1.0, 2.0);
	EXPECT_EQ(desaturated(inside), inside);
	const glm::dvec3 deep_red(
			1.0 / kLuminanceWeights.x + 0.5 * kLuminanceWeights.z / kLuminanceWeights.x, 0.0, -0.5);
	const glm::dvec3 shown = desaturated(deep_red);
	EXPECT_NEAR(glm::dot(shown, kLuminanceWeights), 1.0, 1e-12);
	EXPECT_NEAR(shown.z, 0.0, 1e-15);
}

} // namespace
} // namespace blackhole
