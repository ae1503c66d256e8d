// SPDX-License-Identifier: MIT
#include "core/culling/image_bound.h"

#include "core/photometry/planck_table.h"
#include "core/relativity/star_image.h"

#include <cmath>
#include <numbers>
#include <random>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace blackhole {
namespace {

class ImageBound : public testing::TestWithParam<ObserverMotion> {
protected:
	std::mt19937_64 random{11};

	double uniform(double low, double high) {
		return std::uniform_real_distribution<double>(low, high)(random);
	}
	glm::dvec3 direction() {
		const double z = uniform(-1.0, 1.0);
		const double angle = uniform(0.0, 2.0 * std::numbers::pi);
		return glm::dvec3(
				std::sqrt(1.0 - z * z) * std::cos(angle), std::sqrt(1.0 - z * z) * std::sin(angle), z);
	}
};

TEST_P(ImageBound, IsNeverShortOfTheExactBrightness) {
	const PlanckTable planck;
	double least_reserve = 1e9;
	double sum_reserve = 0.0;
	int counted = 0;
	for (int trial = 0; trial < 20000; ++trial) {
		const double lowest = GetParam() == ObserverMotion::kStatic ? std::log(1.02) : std::log(0.06);
		const glm::dvec3 position = direction() * std::exp(uniform(lowest, std::log(1e6)));
		StarGroup group;
		group.centre = direction();
		group.angular_radius = std::exp(uniform(std::log(0.001), std::log(0.6)));
		group.brightest_v = 5.0F;
		group.coolest_k = static_cast<float>(uniform(2500.0, 6000.0));
		group.hottest_k = static_cast<float>(uniform(6000.0, 40000.0));
		// A star somewhere inside.
		const glm::dvec3 aside = glm::normalize(glm::cross(group.centre, direction()));
		const double off = group.angular_radius * std::sqrt(uniform(0.0, 1.0));
		const glm::dvec3 star = group.centre * std::cos(off) + aside * std::sin(off);
		const double temperature = uniform(group.coolest_k, group.hottest_k);
		const int order = static_cast<int>(uniform(0.0, 3.999));

		const Outcome<StarImage> image = star_image(position, star, order, GetParam());
		ASSERT_TRUE(image) << image.error;
		const double gain = std::log2(image.value->magnification) +
				planck.log2_luminance(image.value->redshift * temperature) -
				planck.log2_luminance(temperature);
		const double exact = 5.0 - 2.5 * std::log10(2.0) * gain;
		const double bound =
				brightest_image_magnitude(eye_bound(position, GetParam()), group, order, 0.0, planck);
		EXPECT_LE(bound, exact + 1e-6) << "order " << order << " r " << glm::length(position);
		if (group.angular_radius < 0.01 && std::isfinite(bound) && order > 0) {
			least_reserve = std::min(least_reserve, exact - bound);
			sum_reserve += exact - bound;
			++counted;
		}
	}
	ASSERT_GT(counted, 100);
	EXPECT_GE(least_reserve, 0.0);
	// Useful as well: small groups are bounded within about two magnitudes.
	EXPECT_LT(sum_reserve / counted, 2.25);
}

INSTANTIATE_TEST_SUITE_P(
		Motions, ImageBound, testing::Values(ObserverMotion::kStatic, ObserverMotion::kRain));

} // namespace
} // namespace blackhole
