// SPDX-License-Identifier: MIT
#include "core/culling/star_groups.h"

#include "core/catalogue/star.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace blackhole {
namespace {

StarTable random_table(std::size_t count) {
	std::mt19937_64 random(7);
	std::uniform_real_distribution<double> unit(0.0, 1.0);
	StarTable table;
	for (std::size_t i = 0; i < count; ++i) {
		Star star;
		star.right_ascension = 2.0 * std::numbers::pi * unit(random);
		star.declination = std::asin(2.0 * unit(random) - 1.0);
		star.v_magnitude = static_cast<float>(14.0 * std::sqrt(unit(random)));
		star.temperature_k = static_cast<float>(2500.0 + 20000.0 * unit(random));
		table.stars.push_back(star);
	}
	table.sort_by_magnitude();
	return table;
}

std::vector<StarGroup> grouped(const StarTable &table) {
	return group_stars(table, star_directions(table), PlanckTable());
}

TEST(StarGroups, EveryStarIsInExactlyOneGroupAndInsideItsBounds) {
	const StarTable table = random_table(60000);
	const PlanckTable planck;
	std::vector<int> seen(table.stars.size(), 0);
	for (const StarGroup &group : grouped(table)) {
		ASSERT_FALSE(group.stars.empty());
		ASSERT_EQ(group.ranks.size(), group.stars.size());
		EXPECT_TRUE(std::is_sorted(group.ranks.begin(), group.ranks.end()));
		for (std::size_t i = 0; i < group.stars.size(); ++i) {
			const std::uint32_t index = group.stars[i];
			const Star &star = table.stars[index];
			++seen[index];
			EXPECT_LE(group.ranks[i], star.v_magnitude);
			for (const double ln_g : {-1.0, 0.06, 0.3}) {
				const double temperature = star.temperature_k;
				const double gain = 2.5 * std::log10(2.0) *
						(planck.log2_luminance(std::exp(ln_g) * temperature) -
								planck.log2_luminance(temperature));
				const double bound = 2.5 * std::log10(2.0) * group.shift.log2_gain(ln_g);
				EXPECT_LE(group.ranks[i] - bound, star.v_magnitude - gain + 1e-5);
			}
			EXPECT_GE(glm::dot(group.centre, world_direction(star)), std::cos(group.angular_radius) - 1e-12);
		}
	}
	for (const int count : seen) {
		ASSERT_EQ(count, 1);
	}
}

TEST(StarGroups, AreSmallPartsOfTheSky) {
	const std::vector<StarGroup> groups = grouped(random_table(118217));
	EXPECT_LE(groups.size(), 150U);
	for (const StarGroup &group : groups) {
		EXPECT_LT(group.angular_radius, 0.3);
	}
}

TEST(StarGroups, OfVeryManyStarsAreSmaller) {
	const std::vector<StarGroup> groups = grouped(random_table(kManyStars));
	EXPECT_LE(groups.size(), 600U);
	std::size_t stars = 0;
	for (const StarGroup &group : groups) {
		EXPECT_LT(group.angular_radius, 0.15);
		EXPECT_TRUE(std::is_sorted(group.ranks.begin(), group.ranks.end()));
		stars += group.stars.size();
	}
	EXPECT_EQ(stars, kManyStars);
}

TEST(StarDirections, AreThoseOfTheStarsInTheirOrder) {
	const StarTable table = random_table(50000);
	const std::vector<glm::dvec3> directions = star_directions(table);
	ASSERT_EQ(directions.size(), table.stars.size());
	for (std::size_t i = 0; i < directions.size(); ++i) {
		ASSERT_EQ(directions[i], world_direction(table.stars[i]));
	}
}

TEST(StarGroups, AnEmptyCatalogueHasNoGroupAndOneStarHasOne) {
	EXPECT_TRUE(grouped(StarTable()).empty());
	EXPECT_EQ(grouped(random_table(1)).size(), 1U);
}

} // namespace
} // namespace blackhole
