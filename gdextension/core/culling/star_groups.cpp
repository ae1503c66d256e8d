// SPDX-License-Identifier: MIT
#include "core/culling/star_groups.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <glm/geometric.hpp>

namespace blackhole {
namespace {

struct Level {
	std::size_t first_rank; // the brightest star of the level
	int divisions;          // cells along a cube face's edge; 0: the whole sky is one cell
};

constexpr std::array<Level, 4> kLevels = {{{0, 0}, {1024, 1}, {8192, 2}, {32768, 4}}};

int cell_count(const Level &level) {
	return level.divisions == 0 ? 1 : 6 * level.divisions * level.divisions;
}

int division_of(double coordinate, int divisions) {
	// Equal angles rather than equal lengths, so that cells are of like size.
	const double along = std::atan(coordinate) / std::atan(1.0);
	return std::clamp(static_cast<int>((along + 1.0) * 0.5 * divisions), 0, divisions - 1);
}

int cell_of(const glm::dvec3 &direction, int divisions) {
	if (divisions == 0) {
		return 0;
	}
	const glm::dvec3 size = glm::dvec3(std::abs(direction.x), std::abs(direction.y), std::abs(direction.z));
	int axis = 0;
	if (size.y >= size.x && size.y >= size.z) {
		axis = 1;
	} else if (size.z >= size.x) {
		axis = 2;
	}
	const double major = direction[axis];
	const double s = direction[(axis + 1) % 3] / std::abs(major);
	const double t = direction[(axis + 2) % 3] / std::abs(major);
	const int face = 2 * axis + (major < 0.0 ? 1 : 0);
	return (face * divisions + division_of(s, divisions)) * divisions + division_of(t, divisions);
}

void bound(const StarTable &table, StarGroup &group) {
	glm::dvec3 sum(0.0);
	group.brightest_v = table.stars[group.stars.front()].v_magnitude;
	group.coolest_k = group.hottest_k = table.stars[group.stars.front()].temperature_k;
	for (const std::uint32_t index : group.stars) {
		const Star &star = table.stars[index];
		sum += world_direction(star);
		group.coolest_k = std::min(group.coolest_k, star.temperature_k);
		group.hottest_k = std::max(group.hottest_k, star.temperature_k);
	}
	const double length = glm::length(sum);
	group.centre = length > 0.0 ? sum / length : glm::dvec3(1.0, 0.0, 0.0);
	double nearest_cosine = 1.0;
	for (const std::uint32_t index : group.stars) {
		nearest_cosine =
				std::min(nearest_cosine, glm::dot(group.centre, world_direction(table.stars[index])));
	}
	group.angular_radius = std::acos(std::clamp(nearest_cosine, -1.0, 1.0)) + 1e-9;
}

} // namespace

std::vector<StarGroup> group_stars(const StarTable &table) {
	std::vector<StarGroup> groups;
	for (std::size_t level = 0; level < kLevels.size(); ++level) {
		const std::size_t first = kLevels[level].first_rank;
		const std::size_t end = level + 1 < kLevels.size()
				? std::min(table.stars.size(), kLevels[level + 1].first_rank)
				: table.stars.size();
		if (first >= end) {
			break;
		}
		std::vector<StarGroup> cells(static_cast<std::size_t>(cell_count(kLevels[level])));
		for (std::size_t rank = first; rank < end; ++rank) {
			const int cell = cell_of(world_direction(table.stars[rank]), kLevels[level].divisions);
			cells[static_cast<std::size_t>(cell)].stars.push_back(static_cast<std::uint32_t>(rank));
		}
		for (StarGroup &cell : cells) {
			if (!cell.stars.empty()) {
				bound(table, cell);
				groups.push_back(std::move(cell));
			}
		}
	}
	return groups;
}

} // namespace blackhole
