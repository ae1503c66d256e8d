// SPDX-License-Identifier: MIT
#include "core/overlay/figure_field.h"

#include "core/overlay/cube_map.h"
#include "tests/overlay/cube_sampler.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace blackhole {
namespace {

/// A pixel of a picture of 1280 x 720 with a field of view of 60 degrees, radians: what errors count against.
constexpr double kPixel = 0.00145;

class FigureFieldTest : public testing::Test {
protected:
	glm::dvec3 random_direction() {
		return glm::normalize(glm::dvec3(_normal(_random), _normal(_random), _normal(_random)));
	}

	/// A number from `from` to `to`.
	double random_number(double from, double to) {
		return std::uniform_real_distribution<double>(from, to)(_random);
	}

	/// The point `along` from the segment's start and `aside` from its circle, radians.
	static glm::dvec3 beside(const SkySegment &segment, double along, double aside) {
		const glm::dvec3 pole = glm::normalize(glm::cross(segment.from, segment.to));
		const glm::dvec3 on =
				std::cos(along) * segment.from + std::sin(along) * glm::cross(pole, segment.from);
		return std::cos(aside) * on + std::sin(aside) * pole;
	}

	SkySegment random_segment(double length) {
		const glm::dvec3 from = random_direction();
		return {from, beside({from, random_direction()}, length, 0.0)};
	}

	static FigureField baked(const std::vector<SkySegment> &segments, int size = kFigureFieldSize) {
		auto outcome = bake_figure_field(segments, size);
		EXPECT_TRUE(outcome) << outcome.error;
		return outcome ? std::move(*outcome.value) : FigureField();
	}

private:
	std::mt19937_64 _random{5};
	std::normal_distribution<double> _normal;
};

TEST_F(FigureFieldTest, TexelsHoldTheVectorToTheNearestPoint) {
	const std::vector<SkySegment> segments = {random_segment(0.4), random_segment(0.2), random_segment(1.0)};
	constexpr int kSize = 40; // no multiple of the tiles
	const FigureField field = baked(segments, kSize);
	ASSERT_EQ(field.texels.size(), std::size_t{4 * 6 * kSize * kSize});
	int within = 0;
	for (std::size_t i = 0; i < field.texels.size() / 4; ++i) {
		const int column = int(i % kSize);
		const int row = int(i / kSize % kSize);
		const glm::dvec3 direction = texel_direction(int(i / (kSize * kSize)), column, row, kSize);
		double cosine = -1.0;
		glm::dvec3 nearest(0.0);
		for (const SkySegment &segment : segments) {
			const SegmentDistance distance(segment);
			if (distance.cosine(direction) > cosine) {
				cosine = distance.cosine(direction);
				nearest = distance.nearest_point(direction);
			}
		}
		const bool near = std::acos(cosine) < kFigureFieldReach;
		within += near ? 1 : 0;
		const glm::dvec3 expected = near ? nearest - direction : kFigureFieldReach * direction;
		const float *texel = field.texels.data() + 4 * i;
		ASSERT_LT(glm::distance(glm::dvec3(texel[0], texel[1], texel[2]), expected), 1e-7);
		ASSERT_NEAR(texel[3], glm::length(expected), 1e-7);
	}
	EXPECT_GT(within, 100);
}

TEST_F(FigureFieldTest, BesideALineTheDistanceIsExactBetweenTexels) {
	constexpr double kLength = 0.5;
	constexpr double kTwoTexels = 4.0 / kFigureFieldSize;
	for (int turn = 0; turn < 6; ++turn) {
		const SkySegment segment = random_segment(kLength);
		const FigureField field = baked({segment});
		for (int i = 0; i < 20000; ++i) {
			const double aside = random_number(-0.055, 0.055);
			const glm::dvec3 direction =
					beside(segment, random_number(kTwoTexels, kLength - kTwoTexels), aside);
			const double tolerance = takes_two_faces(direction, field.size) ? 0.3 * kPixel : 1e-5;
			ASSERT_NEAR(sampled_distance(field, direction), std::abs(aside), tolerance);
		}
	}
}

TEST_F(FigureFieldTest, EndsOfLinesAreRoundToAFractionOfAPixel) {
	for (int turn = 0; turn < 6; ++turn) {
		const SkySegment segment = random_segment(0.2);
		const SegmentDistance distance(segment);
		const FigureField field = baked({segment});
		for (int i = 0; i < 5000; ++i) {
			const glm::dvec3 direction =
					beside(segment, random_number(-0.03, 0.03), random_number(-0.03, 0.03));
			const double exact = std::acos(std::min(1.0, distance.cosine(direction)));
			ASSERT_NEAR(sampled_distance(field, direction), exact, 0.75 * kPixel);
		}
	}
}

TEST_F(FigureFieldTest, BetweenParallelLinesThereIsNoThirdOne) {
	const SkySegment segment = random_segment(0.5);
	const SkySegment parallel{beside(segment, 0.0, 0.02), beside(segment, 0.5, 0.02)};
	const FigureField field = baked({segment, parallel});
	double shortest_vector = 1.0;
	for (int i = 0; i < 20000; ++i) {
		const glm::dvec3 direction = beside(segment, random_number(0.05, 0.45), random_number(0.006, 0.014));
		EXPECT_GT(sampled_distance(field, direction), 0.0035);
		shortest_vector = std::min(shortest_vector, glm::length(glm::dvec3(sample(field, direction))));
	}
	EXPECT_LT(shortest_vector, 0.001) << "then the fourth channel would not be needed";
}

TEST_F(FigureFieldTest, PastTheReachNothingIsNear) {
	const SkySegment segment = random_segment(0.3);
	const SegmentDistance distance(segment);
	const FigureField field = baked({segment}, 64);
	int far = 0;
	for (int i = 0; i < 20000; ++i) {
		const glm::dvec3 direction = random_direction();
		if (distance.cosine(direction) < std::cos(kFigureFieldReach)) {
			++far;
			EXPECT_GT(glm::length(glm::dvec3(sample(field, direction))), 0.6 * kFigureFieldReach);
		}
	}
	EXPECT_GT(far, 10000);
}

TEST_F(FigureFieldTest, FacesMeetWithoutASeam) {
	std::vector<SkySegment> segments;
	for (int i = 0; i < 300; ++i) {
		segments.push_back(random_segment(0.3));
	}
	const FigureField field = baked(segments, 128);
	for (int i = 0; i < 5000; ++i) {
		// Right at the edge between two faces, a little to either side.
		const int axis = i % 3;
		const double along = random_number(-0.98, 0.98);
		glm::dvec3 edge(i % 2 == 0 ? 1.0 : -1.0);
		edge[(axis + 1) % 3] = i % 4 < 2 ? 1.0 : -1.0;
		edge[axis] = along;
		glm::dvec3 across(0.0);
		across[(axis + 1) % 3] = 1e-9;
		const glm::dvec4 one = sample(field, glm::normalize(edge + across));
		const glm::dvec4 other = sample(field, glm::normalize(edge - across));
		EXPECT_LT(glm::distance(glm::dvec3(one), glm::dvec3(other)), 1e-6);
		EXPECT_NEAR(one.w, other.w, 1e-6);
	}
}

TEST_F(FigureFieldTest, ProgressRisesAndCancels) {
	std::vector<double> parts;
	const auto watch = [&parts](double part) {
		parts.push_back(part);
		return true;
	};
	ASSERT_TRUE(bake_figure_field({random_segment(0.3)}, 64, kFigureFieldReach, watch));
	EXPECT_TRUE(std::is_sorted(parts.begin(), parts.end()));
	EXPECT_GT(parts.size(), 6U);
	EXPECT_EQ(parts.back(), 1.0);
	int calls = 0;
	const auto stop = [&calls](double) { return ++calls < 3; };
	const auto stopped = bake_figure_field({random_segment(0.3)}, 64, kFigureFieldReach, stop);
	EXPECT_FALSE(stopped);
	EXPECT_EQ(calls, 3);
	EXPECT_NE(stopped.error.find("cancelled"), std::string::npos);
}

TEST_F(FigureFieldTest, ImpossibleRequestsAreRefused) {
	const SkySegment good = random_segment(0.3);
	const double nan = std::numeric_limits<double>::quiet_NaN();
	EXPECT_FALSE(bake_figure_field({good}, 7));
	EXPECT_FALSE(bake_figure_field({good}, 5000));
	EXPECT_FALSE(bake_figure_field({good}, 64, 0.0));
	EXPECT_FALSE(bake_figure_field({good}, 64, nan));
	for (const SkySegment &bad : {SkySegment{{nan, 0.0, 0.0}, good.to}, SkySegment{2.0 * good.from, good.to},
				 SkySegment{good.from, -good.from}}) {
		const auto outcome = bake_figure_field({good, bad}, 64);
		ASSERT_FALSE(outcome);
		EXPECT_NE(outcome.error.find("Segment 1"), std::string::npos) << outcome.error;
	}
	EXPECT_TRUE(bake_figure_field({}, 8)) << "no figure at all is fine";
}

} // namespace
} // namespace blackhole
