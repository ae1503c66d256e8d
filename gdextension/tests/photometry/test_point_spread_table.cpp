// SPDX-License-Identifier: MIT
// The table from which stars are drawn conserves light, follows the formulas, and cuts stars off where it
// says.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/photometry/pixel_blur.h"
#include "core/photometry/point_spread_table.h"
#include "tests/photometry/profile_shader.h"

namespace {

using namespace blackhole;
using std::numbers::pi;

const PointSpreadTable &airy() {
	static const PointSpreadTable table(PointSpread::kAiry, 0.0);
	return table;
}

const PointSpreadTable &eye() {
	static const PointSpreadTable table(PointSpread::kEye, kEyeGlare);
	return table;
}

/// Integral of the table's profile within p_reach, faded out towards there if so wished.
double light_of(const PointSpreadTable &p_table, double p_reach, double p_v, bool p_faded) {
	const int steps = 40000;
	double sum = 0.0;
	for (int i = 0; i < steps; ++i) {
		const double part = (i + 0.5) / steps;
		const double t = p_reach * part;
		const double fade = p_faded ? PointSpreadTable::fade(part) : 1.0;
		sum += 2.0 * pi * t * p_table.profile(t, p_v) * fade * p_reach / steps;
	}
	return sum;
}

TEST(PointSpreadTable, AiryHoldsRayleighsLight) {
	// The bare pattern, and where the pixel's blur is small against the radius.
	for (const double t : {3.8317, 7.0156, 30.0, 100.0}) {
		EXPECT_NEAR(light_of(airy(), t, 1.0, false), airy_encircled(t), 1e-3) << t;
	}
	for (const double v : {1.0 / 16.0, 0.2, 0.5, 0.77, 0.93}) {
		EXPECT_NEAR(light_of(airy(), 60.0, v, false), airy_encircled(60.0 / v), 1e-3) << v;
	}
}

TEST(PointSpreadTable, EyeHoldsItsLight) {
	for (const double v : {1.0 / 16.0, 0.2, 0.5, 0.77, 0.93, 1.0}) {
		const double x = 60.0 / v;
		EXPECT_NEAR(light_of(eye(), 60.0, v, false), 1.0 - kEyeGlare * (1.0 - eye_wings_encircled(x)), 2e-3)
				<< v;
	}
}

TEST(PointSpreadTable, FollowsTheBlurredPatternBetweenItsNodes) {
	for (const double v : {0.1, 0.3, 0.55, 0.8, 0.95}) {
		const auto encircled = [v](double r) { return airy_encircled(r / v); };
		const double sigma = std::sqrt(1.0 - v * v);
		const double peak = pixel_blurred(encircled, sigma, 0.0);
		for (const double t : {0.0, 0.4, 1.1, 2.3, 3.4, 4.9}) {
			EXPECT_NEAR(airy().profile(t, v), pixel_blurred(encircled, sigma, t), 6e-3 * peak)
					<< "v " << v << " t " << t;
		}
	}
}

TEST(PointSpreadTable, FadedLightIsTheIntegral) {
	for (const PointSpreadTable *table : {&airy(), &eye()}) {
		for (const double v : {0.0, 0.21, 0.6, 1.0}) {
			for (const double reach : {3.0, 4.5, 12.0, 90.0}) {
				EXPECT_NEAR(table->faded_light(reach, v), light_of(*table, reach, v, true), 2e-3)
						<< "v " << v << " reach " << reach;
			}
		}
	}
}

TEST(PointSpreadTable, CutsWhereALightFallsBelowTheLimit) {
	for (const PointSpreadTable *table : {&airy(), &eye()}) {
		for (const double v : {0.1, 0.4, 0.85}) {
			double last = 0.0;
			for (double contrast = 10.0; contrast < 1e9; contrast *= 1.3) {
				const double cut = table->cut_radius(contrast, v);
				EXPECT_GE(cut, last) << contrast;
				// A little more light, a little larger: nothing pops.
				EXPECT_LT(cut, std::max(1.15 * last, 4.5)) << contrast;
				const bool whole =
						cut > 0.9 * PointSpreadTable::kReach; // then nothing is known of what is beyond
				for (double t = cut; !whole && t < PointSpreadTable::kReach; t *= 1.02) {
					EXPECT_LT(contrast * table->profile(t, v), 1.25) << contrast << " at " << t;
				}
				last = cut;
			}
			EXPECT_DOUBLE_EQ(last, PointSpreadTable::kReach);
		}
	}
}

TEST(PointSpreadTable, GlareMovesLightIntoTheWings) {
	const PointSpreadTable none(PointSpread::kEye, 0.0);
	const PointSpreadTable all(PointSpread::kEye, 1.0);
	EXPECT_NEAR(light_of(none, 8.0, 0.3, false), 1.0, 1e-3);
	EXPECT_LT(light_of(all, 8.0, 0.3, false), 0.9);
	EXPECT_NEAR(all.profile(20.0, 0.3), eye().profile(20.0, 0.3) / kEyeGlare, 1e-9);
}

TEST(PointSpreadTable, ShaderReadsIt) {
	const std::vector<float> texels = eye().texels();
	ASSERT_EQ(texels.size(), 4 * 512 * 3 * 16);
	for (const float v : {0.0F, 0.03F, 0.5F, 0.97F, 1.0F}) {
		for (const float t : {0.0F, 0.7F, 5.0F, 60.0F, 127.9F, 128.0F, 500.0F}) {
			const double within = std::min(double{t}, PointSpreadTable::kReach);
			const double light = eye().profile(within, v);
			EXPECT_NEAR(shader::profile_light(texels, t, v), light, 1e-3 * light + 1e-12) << t;
			EXPECT_NEAR(shader::profile_faded_light(texels, t, v), eye().faded_light(within, v), 1e-4) << t;
		}
		for (const float contrast : {20.0F, 1e4F, 1e20F}) {
			EXPECT_NEAR(shader::profile_cut(texels, contrast, v), eye().cut_radius(contrast, v), 1e-2)
					<< contrast;
		}
		const float enough = 1.0F / shader::profile_light(texels, 0.0F, v);
		EXPECT_FALSE(shader::profile_is_seen(texels, 0.99F * enough, v));
		EXPECT_TRUE(shader::profile_is_seen(texels, 1.01F * enough, v));
	}
	for (const double part : {0.0, 0.3, 0.6, 0.9, 1.0}) {
		EXPECT_NEAR(shader::profile_fade(static_cast<float>(part)), PointSpreadTable::fade(part), 1e-6);
	}
}

} // namespace
