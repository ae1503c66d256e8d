// SPDX-License-Identifier: MIT
#include "core/culling/star_rows.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "core/photometry/radiometry.h"

namespace blackhole {
namespace {

TEST(StarRows, HoldWhatTheShaderReads) {
	StarTable table;
	table.stars = {{0.3, 0.2, 2.0F, kUnknown, 4000.0F, kUnknown, 0, 0},
			{4.0, -1.0, 11.5F, kUnknown, 25000.0F, kUnknown, 0, 0}};
	const PlanckTable planck;
	const std::vector<glm::dvec3> directions = star_directions(table);
	StarGroup group;
	group.stars = {1, 0};
	std::vector<float> rows(group.stars.size() * kFloatsPerStar);
	pack_rows(table, directions, group, planck, rows.data());
	for (std::size_t i = 0; i < 2; ++i) {
		const Star &star = table.stars[group.stars[i]];
		const glm::dvec3 direction = world_direction(star);
		const float *row = rows.data() + i * kFloatsPerStar;
		EXPECT_NEAR(row[0] / std::pow(10.0, -0.4 * star.v_magnitude), 1.0, 1e-6);
		const double radius = star_angular_radius(star.v_magnitude, star.temperature_k, planck);
		EXPECT_NEAR(row[1] / radius, 1.0, 1e-6);
		EXPECT_EQ(row[3], static_cast<float>(direction.x));
		EXPECT_EQ(row[4], star.temperature_k);
		EXPECT_EQ(row[5], star.v_magnitude);
		EXPECT_EQ(row[7], static_cast<float>(direction.y));
		EXPECT_EQ(row[8], static_cast<float>(planck.log2_luminance(star.temperature_k)));
		EXPECT_EQ(row[11], static_cast<float>(direction.z));
	}
}

} // namespace
} // namespace blackhole
