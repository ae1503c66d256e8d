// SPDX-License-Identifier: MIT
#include "core/overlay/sky_segment.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace blackhole {
namespace {

class RandomSky {
public:
	glm::dvec3 direction() {
		return glm::normalize(glm::dvec3(_normal(_random), _normal(_random), _normal(_random)));
	}

private:
	std::mt19937_64 _random{11};
	std::normal_distribution<double> _normal;
};

double angle(const glm::dvec3 &one, const glm::dvec3 &other) {
	return std::atan2(glm::length(glm::cross(one, other)), glm::dot(one, other));
}

/// The least angle to 20001 points along the arc.
double angle_by_steps(const SkySegment &segment, const glm::dvec3 &direction) {
	constexpr int kSteps = 20000;
	const double length = angle(segment.from, segment.to);
	double least = 10.0;
	for (int i = 0; i <= kSteps; ++i) {
		const double part = double(i) / kSteps;
		const glm::dvec3 point =
				std::sin((1.0 - part) * length) * segment.from + std::sin(part * length) * segment.to;
		least = std::min(least, angle(direction, glm::normalize(point)));
	}
	return least;
}

TEST(SegmentDistance, AgreesWithStepsAlongTheArc) {
	RandomSky sky;
	for (int i = 0; i < 200; ++i) {
		const SkySegment segment{sky.direction(), sky.direction()};
		const glm::dvec3 direction = sky.direction();
		const SegmentDistance distance(segment);
		const double exact = std::acos(distance.cosine(direction));
		// Steps are up to 1.6e-4 apart; where the nearest point is an end they meet it.
		EXPECT_NEAR(exact, angle_by_steps(segment, direction), 1e-4);
		const glm::dvec3 nearest = distance.nearest_point(direction);
		EXPECT_NEAR(glm::length(nearest), 1.0, 1e-12);
		EXPECT_NEAR(angle(direction, nearest), exact, 1e-7);
		EXPECT_LT(angle_by_steps(segment, nearest), 1e-4) << "a point of the segment";
	}
}

TEST(SegmentDistance, APointIsASegmentToo) {
	const glm::dvec3 point = glm::normalize(glm::dvec3(1.0, 2.0, 3.0));
	const SegmentDistance distance({point, point});
	const glm::dvec3 direction(0.0, 0.0, 1.0);
	EXPECT_NEAR(distance.cosine(direction), point.z, 1e-15);
	EXPECT_EQ(distance.nearest_point(direction), point);
}

TEST(SegmentDistance, TheFarSideOfTheCircleIsNotTheSegment) {
	const SegmentDistance distance({{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}});
	EXPECT_NEAR(distance.cosine({-1.0, 0.0, 0.0}), 0.0, 1e-15) << "the end at y is a quarter turn away";
	EXPECT_EQ(distance.nearest_point({0.0, -0.6, 0.8}), glm::dvec3(1.0, 0.0, 0.0));
}

} // namespace
} // namespace blackhole
