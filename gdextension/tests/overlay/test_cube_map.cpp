// SPDX-License-Identifier: MIT
#include "core/overlay/cube_map.h"

#include "tests/overlay/cube_sampler.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace blackhole {
namespace {

TEST(CubeMap, FacesLookAlongTheAxesInTheirOrder) {
	const glm::dvec3 axes[kCubeFaces] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
	for (int face = 0; face < kCubeFaces; ++face) {
		EXPECT_EQ(cube_point(face, 0.0, 0.0), axes[face]) << face;
	}
}

TEST(CubeMap, TexelsAreWhereGpusLookForThem) {
	constexpr int kSize = 16;
	for (int face = 0; face < kCubeFaces; ++face) {
		for (int row = 0; row < kSize; ++row) {
			for (int column = 0; column < kSize; ++column) {
				const glm::dvec3 direction = texel_direction(face, column, row, kSize);
				EXPECT_NEAR(glm::length(direction), 1.0, 1e-15);
				const CubePlace place = cube_place(direction, kSize);
				EXPECT_EQ(place.face, face);
				EXPECT_NEAR(place.column, column + 0.5, 1e-12);
				EXPECT_NEAR(place.row, row + 0.5, 1e-12);
			}
		}
	}
}

} // namespace
} // namespace blackhole
