// SPDX-License-Identifier: MIT
// The field of the 88 figures that come with the addon, against the distance computed from every segment.
#include "core/overlay/figure_field.h"

#include "tests/overlay/cube_sampler.h"
#include "tests/overlay/shipped_figures.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace blackhole {
namespace {

/// A pixel of a picture of 1280 x 720 with a field of view of 60 degrees, radians.
constexpr double kPixel = 0.00145;

class ShippedFigureField : public testing::Test {
protected:
	static void SetUpTestSuite() {
		s_segments = shipped_figures();
		ASSERT_GT(s_segments.size(), 600U);
		s_distances = std::vector<SegmentDistance>(s_segments.begin(), s_segments.end());
		const auto start = std::chrono::steady_clock::now();
		auto outcome = bake_figure_field(s_segments);
		s_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
		ASSERT_TRUE(outcome) << outcome.error;
		s_field = std::move(*outcome.value);
	}

	struct Near {
		double first = 0.0;  ///< angle to the nearest segment, radians
		double second = 0.0; ///< angle to the next one after it
		double end = 0.0;    ///< angle from the nearest point to the nearest segment's nearer end
	};

	static Near near(const glm::dvec3 &direction) {
		double first = -1.0;
		double second = -1.0;
		std::size_t index = 0;
		for (std::size_t i = 0; i < s_distances.size(); ++i) {
			const double cosine = s_distances[i].cosine(direction);
			second = std::max(second, std::min(first, cosine));
			if (cosine > first) {
				first = cosine;
				index = i;
			}
		}
		const glm::dvec3 point = s_distances[index].nearest_point(direction);
		const SkySegment &segment = s_segments[index];
		const double end = std::max(glm::dot(point, segment.from), glm::dot(point, segment.to));
		const auto angle = [](double cosine) { return std::acos(std::min(1.0, cosine)); };
		return {angle(first), angle(second), angle(end)};
	}

	/// A point of a segment, by chance.
	glm::dvec3 point_on_a_line() {
		const SkySegment &segment = s_segments[_random() % s_segments.size()];
		const double part = std::uniform_real_distribution<double>()(_random);
		const double length = std::acos(glm::dot(segment.from, segment.to));
		return glm::normalize(
				std::sin((1.0 - part) * length) * segment.from + std::sin(part * length) * segment.to);
	}

	glm::dvec3 moved(const glm::dvec3 &direction, double by) {
		std::uniform_real_distribution<double> step(-by, by);
		return glm::normalize(direction + glm::dvec3(step(_random), step(_random), step(_random)));
	}

	std::mt19937_64 _random{3};
	static inline std::vector<SkySegment> s_segments;
	static inline std::vector<SegmentDistance> s_distances;
	static inline FigureField s_field;
	static inline double s_seconds = 0.0;
};

TEST_F(ShippedFigureField, IsMadeWithinASecond) {
	EXPECT_LT(s_seconds, 1.0);
}

TEST_F(ShippedFigureField, IsExactNearLinesThatAreAlone) {
	int checked = 0;
	for (int i = 0; i < 6000; ++i) {
		const glm::dvec3 direction = moved(point_on_a_line(), 0.01);
		const Near here = near(direction);
		if (here.second > here.first + 4.0 * s_field.margin && here.end > 2.0 * s_field.margin) {
			++checked;
			const double tolerance = takes_two_faces(direction, s_field.size) ? 0.3 * kPixel : 1e-5;
			EXPECT_NEAR(sampled_distance(s_field, direction), here.first, tolerance);
		}
	}
	EXPECT_GT(checked, 2000);
}

TEST_F(ShippedFigureField, LinesAreUnbrokenWhereTheyMeet) {
	std::vector<double> errors;
	for (int i = 0; i < 50000; ++i) {
		errors.push_back(sampled_distance(s_field, point_on_a_line()));
	}
	std::sort(errors.begin(), errors.end());
	EXPECT_LT(errors[errors.size() * 9 / 10], 1e-5);
	EXPECT_LT(errors[errors.size() * 99 / 100], 0.5 * kPixel);
	EXPECT_LT(errors.back(), 1.25 * kPixel);
}

TEST_F(ShippedFigureField, NothingIsDrawnFarFromALine) {
	int drawn = 0;
	for (int i = 0; i < 30000; ++i) {
		const glm::dvec3 direction = moved(point_on_a_line(), 0.03);
		const double sampled = sampled_distance(s_field, direction);
		drawn += sampled < kPixel ? 1 : 0;
		EXPECT_GT(sampled, near(direction).first - 2.0 * s_field.margin);
	}
	EXPECT_GT(drawn, 500);
}

} // namespace
} // namespace blackhole
