// SPDX-License-Identifier: MIT
#include "core/culling/image_bound.h"

#include "core/photometry/planck_table.h"
#include "core/relativity/star_image.h"
#include "core/tables/lensing_tables.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <string>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace blackhole {
namespace {

/// The nearest place, in r_s, where such observers are.
double lowest_place(ObserverMotion motion) {
	switch (motion) {
		case ObserverMotion::kStatic:
			return 1.02;
		case ObserverMotion::kOrbit:
			return 1.6;
		default:
			return 0.06;
	}
}

ObserverField orbiting() {
	ObserverField field(ObserverMotion::kOrbit);
	field.axis = glm::dvec3(0.3, -0.5, 0.8);
	return field;
}

ObserverField flying() {
	ObserverField field(ObserverMotion::kVelocity);
	field.celerity = glm::dvec3(0.5, 0.8, -0.3);
	return field;
}

class ImageBoundTest : public testing::TestWithParam<ObserverField> {
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

TEST_P(ImageBoundTest, IsNeverShortOfTheExactBrightness) {
	const PlanckTable planck;
	const LensingTables tables = bake_lensing_tables();
	double sum_reserve = 0.0;
	int counted = 0;
	for (int place = 0; place < 250; ++place) {
		const double lowest = std::log(lowest_place(GetParam().motion));
		const glm::dvec3 position = direction() * std::exp(uniform(lowest, std::log(1e6)));
		const LocalObserver eye = drawn_observer(position, GetParam());
		const int order = place % 4;
		const ImageBound image_bound(eye, order, tables, [](double, double) { return 1.0; });
		for (int trial = 0; trial < 80; ++trial) {
			const double coolest = uniform(2500.0, 6000.0);
			const double hottest = uniform(6000.0, 40000.0);
			StarGroup group;
			group.centre = direction();
			group.angular_radius = std::exp(uniform(std::log(0.001), std::log(0.6)));
			group.shift = ShiftBound(coolest, hottest, planck);
			// A star somewhere inside.
			const glm::dvec3 aside = glm::normalize(glm::cross(group.centre, direction()));
			const double off = group.angular_radius * std::sqrt(uniform(0.0, 1.0));
			const glm::dvec3 star = group.centre * std::cos(off) + aside * std::sin(off);
			const double temperature = uniform(coolest, hottest);

			const Outcome<StarImage> image = star_image(position, star, order, GetParam());
			ASSERT_TRUE(image) << image.error;
			const double exact = 2.5 * std::log10(2.0) *
					(std::log2(image.value->magnification) +
							planck.log2_luminance(image.value->redshift * temperature) -
							planck.log2_luminance(temperature));
			const double bound = image_bound.brightening(group, 0.0);
			EXPECT_GE(bound, image_bound.least_brightening());
			EXPECT_GE(bound, exact) << "order " << order << " r " << glm::length(position);
			if (group.angular_radius < 0.01 && std::isfinite(bound)) {
				sum_reserve += bound - exact;
				++counted;
			}
		}
	}
	ASSERT_GT(counted, 1000);
	// Useful as well: what remains is the width of a bin and of the temperatures. Which side of a moving
	// observer an image is on the bounds do not know.
	const bool radial =
			GetParam().motion == ObserverMotion::kStatic || GetParam().motion == ObserverMotion::kRain;
	EXPECT_LT(sum_reserve / counted, radial ? 1.0 : 4.0);
}

class RadialImageBoundTest : public testing::TestWithParam<ObserverMotion> {};

TEST_P(RadialImageBoundTest, CountsWhereInThePictureImagesAre) {
	const LensingTables tables = bake_lensing_tables();
	const LocalObserver eye = drawn_observer(glm::dvec3(0.0, 0.0, 10.0), GetParam());
	double farthest = 0.0;
	const ImageBound bound(eye, 1, tables, [&farthest](double, double to) {
		farthest = std::max(farthest, to);
		return 1.0;
	});
	// Order 1 lies inside the Einstein ring, whose size the kappa of the motion scales.
	constexpr double kStaticRing = 29.8283179057 * std::numbers::pi / 180.0;
	const double ring = 2.0 * std::atan(std::tan(0.5 * kStaticRing) * std::sqrt(0.9) / eye.kappa);
	EXPECT_NEAR(farthest, ring, 1e-5);

	StarGroup group;
	group.centre = glm::dvec3(1.0, 0.0, 0.0);
	group.angular_radius = 0.1;
	group.shift = ShiftBound(5000.0, 6000.0, PlanckTable());
	const ImageBound brighter(eye, 1, tables, [](double, double) { return 10.0; });
	EXPECT_NEAR(brighter.brightening(group, 0.0) - bound.brightening(group, 0.0), 2.5, 1e-9);
	EXPECT_GT(bound.brightening(group, 0.2), bound.brightening(group, 0.0));
}

TEST_P(RadialImageBoundTest, LeavesOutWhatIsNotInThePicture) {
	const LensingTables tables = bake_lensing_tables();
	const ShiftBound shift(5000.0, 6000.0, PlanckTable());
	std::mt19937_64 random{5};
	std::normal_distribution<double> normal;
	const auto direction = [&] {
		return glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
	};
	constexpr double kFrom = 0.45;
	constexpr double kTo = 0.8;
	int left_out = 0;
	int seen = 0;
	for (int order = 0; order < 2; ++order) {
		const glm::dvec3 position(0.0, 4.8, 3.6);
		const LocalObserver eye = drawn_observer(position, GetParam());
		const ImageBound bound(eye, order, tables,
				[](double from, double to) { return to >= kFrom && from <= kTo ? 1.0 : 0.0; });
		for (int trial = 0; trial < 500; ++trial) {
			StarGroup group;
			group.centre = direction();
			group.angular_radius = 0.1;
			group.shift = shift;
			const bool drawn = bound.brightening(group, 0.0) > -std::numeric_limits<double>::infinity();
			left_out += drawn ? 0 : 1;
			const glm::dvec3 star = glm::normalize(group.centre + 0.09 * direction());
			const Outcome<StarImage> image = star_image(position, star, order, ObserverField(GetParam()));
			ASSERT_TRUE(image) << image.error;
			if (const double xi = image.value->xi; xi > kFrom && xi < kTo) {
				++seen;
				EXPECT_TRUE(drawn) << "order " << order << " xi " << xi;
			}
		}
		EXPECT_EQ(bound.least_brightening(), -std::numeric_limits<double>::infinity());
	}
	EXPECT_GT(seen, 50);
	EXPECT_GT(left_out, 250);
}

TEST(DrawnObserver, IsTheNearestThereIs) {
	ObserverField fall(ObserverMotion::kInfall);
	fall.energy = 0.5;
	const glm::dvec3 place(0.0, 0.0, 10.0);
	EXPECT_EQ(drawn_observer(place, fall).kappa, radial_kappa(0.1, ObserverMotion::kStatic));
	const glm::dvec3 inside(0.0, 0.0, 0.5);
	EXPECT_EQ(
			drawn_observer(inside, ObserverMotion::kStatic).kappa, radial_kappa(2.0, ObserverMotion::kRain));
	EXPECT_EQ(drawn_observer(inside, orbiting()).celerity, glm::dvec3(0.0));
	ObserverField velocity = flying();
	velocity.relative_to_static = true;
	EXPECT_EQ(drawn_observer(inside, velocity).celerity, velocity.celerity);
}

INSTANTIATE_TEST_SUITE_P(Motions, ImageBoundTest,
		testing::Values(ObserverField(ObserverMotion::kStatic), ObserverField(ObserverMotion::kRain),
				orbiting(), flying()),
		[](const auto &test) { return "Motion" + std::to_string(static_cast<int>(test.param.motion)); });
INSTANTIATE_TEST_SUITE_P(
		Motions, RadialImageBoundTest, testing::Values(ObserverMotion::kStatic, ObserverMotion::kRain));

} // namespace
} // namespace blackhole
