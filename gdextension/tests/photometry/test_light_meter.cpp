// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>
#include <set>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "core/photometry/light_meter.h"

namespace blackhole {
namespace {

/// A meter that sees `p_bright` in the directions below `p_end`, and `p_dim` in the others.
LightMeter looking_at(double p_bright, std::size_t p_end, double p_dim) {
	LightMeter meter;
	for (std::size_t i = 0; i < LightMeter::kDirections; ++i) {
		meter.set_luminance(i, i < p_end ? p_bright : p_dim);
	}
	return meter;
}

TEST(LightMeter, AUniformPictureIsItsOwnMean) {
	for (const double luminance : {1e-12, 0.003, 1.0, 1e9}) {
		EXPECT_NEAR(looking_at(luminance, LightMeter::kDirections, 0.0).mean() / luminance, 1.0, 1e-12);
	}
}

TEST(LightMeter, BlackIsZero) {
	EXPECT_EQ(LightMeter().mean(), 0.0);
}

TEST(LightMeter, TheMeanIsInProportionToTheLight) {
	const double once = looking_at(1.0, 40, 0.01).mean();
	EXPECT_NEAR(looking_at(16.0, 40, 0.16).mean() / once, 16.0, 1e-9);
}

TEST(LightMeter, AShadowCountsAsDimNotAsBottomless) {
	const double half_black = looking_at(0.0, 40, 1.0).mean(); // about half the weight
	EXPECT_GT(half_black, 0.25);
	EXPECT_LT(half_black, 0.5) << "below the arithmetic mean";
}

TEST(LightMeter, ASmallBrightPartIsNotBurntOut) {
	EXPECT_NEAR(looking_at(640.0, 1, 0.0).mean(), 10.0, 1e-9);
	EXPECT_LT(looking_at(1.0, 100, 0.05).mean(), 1.0) << "no matter where much is bright";
	EXPECT_GT(looking_at(1.0, 100, 0.05).mean(), 0.3);
}

TEST(LightMeter, TheCentreCountsMore) {
	EXPECT_GT(looking_at(1.0, 72, 0.1).mean(), looking_at(0.1, 72, 1.0).mean());
}

TEST(LightMeter, DirectionsFillThePictureEvenly) {
	const double half_angle = 0.7;
	int in_half = 0;
	const double half_way = 1.0 - 0.5 * (1.0 - std::cos(half_angle)); // half the solid angle
	glm::dvec3 sum(0.0);
	for (std::size_t i = 0; i < LightMeter::kDirections; ++i) {
		const glm::dvec3 direction = LightMeter::direction(i, half_angle);
		EXPECT_NEAR(glm::length(direction), 1.0, 1e-12);
		EXPECT_GE(direction.z, std::cos(half_angle));
		in_half += direction.z > half_way ? 1 : 0;
		sum += direction;
	}
	EXPECT_EQ(in_half, 72);
	EXPECT_NEAR(glm::normalize(sum).z, 1.0, 1e-4);
	EXPECT_LT(LightMeter::direction(LightMeter::kDirections - 1, std::numbers::pi).z, -0.98) << "all round";
}

TEST(LightMeter, EveryDirectionHasItsTurn) {
	LightMeter meter;
	std::set<std::size_t> seen;
	for (std::size_t i = 0; i < LightMeter::kDirections; ++i) {
		seen.insert(meter.next());
	}
	EXPECT_EQ(seen.size(), LightMeter::kDirections);
}

} // namespace
} // namespace blackhole
