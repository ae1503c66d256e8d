// SPDX-License-Identifier: MIT
// The table, read by the shader's own code, against the integrals it was baked from.
#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "core/photometry/planck.h"
#include "core/photometry/planck_table.h"
#include "tests/photometry/planck_shader.h"

namespace blackhole {
namespace {

/// CIE 1931 (x, y) of linear Rec.709.
glm::dvec2 chromaticity(glm::dvec3 p_rgb) {
	const double x =
			0.4123907992659595 * p_rgb.x + 0.3575843393838780 * p_rgb.y + 0.1804807884018343 * p_rgb.z;
	const double y = glm::dot(kLuminanceWeights, p_rgb);
	const double z =
			0.0193308187155918 * p_rgb.x + 0.1191947797946259 * p_rgb.y + 0.9505321522496608 * p_rgb.z;
	return glm::dvec2(x, y) / (x + y + z);
}

double exact_log2(double p_temperature) {
	return planck_light(p_temperature).ln_luminance * std::numbers::log2e;
}

TEST(PlanckTable, ShaderMatchesTheIntegrals) {
	const auto texels = bake_planck_table();
	double worst_luminance = 0.0;
	double worst_colour = 0.0;
	for (double temperature = 500.0; temperature < 1e6; temperature *= 1.0037) {
		const glm::vec4 light = shader::planck_light(texels, static_cast<float>(temperature));
		const double ratio = std::exp2(double{light.w} - exact_log2(temperature));
		const glm::dvec2 difference = chromaticity(glm::dvec3(light)) - chromaticity(planck_rgb(temperature));
		worst_luminance = std::max(worst_luminance, std::abs(ratio - 1.0));
		worst_colour = std::max({worst_colour, std::abs(difference.x), std::abs(difference.y)});
	}
	RecordProperty("worst_luminance", std::to_string(worst_luminance));
	RecordProperty("worst_colour", std::to_string(worst_colour));
	EXPECT_LT(worst_luminance, 2e-4);
	EXPECT_LT(worst_colour, 5e-5);
}

TEST(PlanckTable, ShaderGoesToBlackAndStaysFinite) {
	const auto texels = bake_planck_table();
	double before = -std::numeric_limits<double>::infinity();
	for (const float temperature : {0.0F, 1e-20F, 1.0F, 2.0F, 10.0F, 100.0F, 249.0F, 250.0F, 251.0F, 400.0F,
				 1e6F, 1e9F, 1e12F, std::numeric_limits<float>::infinity()}) {
		const glm::vec4 light = shader::planck_light(texels, temperature);
		EXPECT_TRUE(std::isfinite(light.x) && std::isfinite(light.y) && std::isfinite(light.z))
				<< temperature;
		EXPECT_TRUE(std::isfinite(light.w)) << temperature;
		EXPECT_GE(double{light.w}, before) << temperature;
		EXPECT_NEAR(glm::dot(glm::dvec3(light), kLuminanceWeights), 1.0, 1e-6) << temperature;
		before = light.w;
	}
	EXPECT_EQ(std::exp2(shader::planck_light(texels, 0.0F).w), 0.0F);
}

TEST(PlanckTable, HotEndKeepsTheRightSlope) {
	const auto texels = bake_planck_table();
	for (const double temperature : {1e6, 1e7, 1e8, 1e9}) {
		const double w = shader::planck_light(texels, static_cast<float>(temperature)).w;
		EXPECT_NEAR(w, exact_log2(temperature), 1e-4) << temperature;
	}
}

TEST(PlanckTable, ShiftedLight) {
	const auto texels = bake_planck_table();
	EXPECT_EQ(shader::planck_shifted(texels, 5772.0F, 1.0F).w, 1.0F);
	for (const double g : {0.2, 0.5, 0.9, 1.5, 3.0, 10.0}) {
		const glm::vec4 light = shader::planck_shifted(texels, 5772.0F, static_cast<float>(g));
		const double factor = std::exp2(exact_log2(g * 5772.0) - exact_log2(5772.0));
		EXPECT_NEAR(light.w / factor, 1.0, 1e-3) << g;
	}
}

TEST(PlanckTable, TheQuickLimitIsNeverShort) {
	const auto texels = bake_planck_table();
	for (double temperature = 1200.0; temperature < 60000.0; temperature *= 1.1) {
		for (double g = 0.1; g < 20.0; g *= 1.05) {
			const double factor =
					shader::planck_shifted(texels, static_cast<float>(temperature), static_cast<float>(g)).w;
			const double limit =
					shader::planck_shifted_limit(static_cast<float>(temperature), static_cast<float>(g));
			EXPECT_GE(limit, factor * (1.0 - 1e-5)) << temperature << ' ' << g;
		}
		// Tight for the slight shifts of far observers.
		EXPECT_LT(shader::planck_shifted_limit(static_cast<float>(temperature), 1.05F),
				1.35F * shader::planck_shifted(texels, static_cast<float>(temperature), 1.05F).w);
	}
}

TEST(PlanckTable, CppReadsItAsTheShaderDoes) {
	const PlanckTable table;
	for (const double temperature : {5.0, 300.0, 1900.0, 5772.0, 40000.0, 1e8}) {
		const double w = shader::planck_light(table.texels(), static_cast<float>(temperature)).w;
		EXPECT_NEAR(table.log2_luminance(temperature), w, 1e-5 + 1e-6 * std::abs(w)) << temperature;
	}
}

TEST(PlanckTable, BakesInMilliseconds) {
	double best_ms = 1e9;
	for (int run = 0; run < 5; ++run) {
		const auto start = std::chrono::steady_clock::now();
		EXPECT_EQ(bake_planck_table().size(), 4 * kPlanckTableSize);
		const std::chrono::duration<double, std::milli> spent = std::chrono::steady_clock::now() - start;
		best_ms = std::min(best_ms, spent.count());
	}
	RecordProperty("bake_ms", std::to_string(best_ms));
#ifdef NDEBUG
	EXPECT_LT(best_ms, 40.0);
#endif
}

} // namespace
} // namespace blackhole
