// SPDX-License-Identifier: MIT
#include "core/culling/star_groups.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include <glm/geometric.hpp>

#include "core/parallel.h"

namespace blackhole {
namespace {

constexpr int kDivisions = 5;         // cells along a cube face's edge
constexpr std::size_t kPiece = 16384; // stars that make a thread worth while

int division_of(double coordinate) {
	// Equal angles rather than equal lengths, so that cells are of like size.
	const double along = std::atan(coordinate) / std::atan(1.0);
	return std::clamp(static_cast<int>((along + 1.0) * 0.5 * kDivisions), 0, kDivisions - 1);
}

std::size_t cell_of(const glm::dvec3 &direction) {
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
	const int cell = (face * kDivisions + division_of(s)) * kDivisions + division_of(t);
	return static_cast<std::size_t>(cell);
}

/// V magnitude less the brightening, in magnitudes, by kRankingShift.
float rank_of(const Star &star, const PlanckTable &planck) {
	const double temperature = star.temperature_k;
	const double gain =
			planck.log2_luminance(kRankingShift * temperature) - planck.log2_luminance(temperature);
	return static_cast<float>(star.v_magnitude - 2.5 * std::log10(2.0) * gain);
}

void rank(const StarTable &table, const PlanckTable &planck, StarGroup &group) {
	std::vector<std::pair<float, std::uint32_t>> ranked;
	ranked.reserve(group.stars.size());
	for (const std::uint32_t index : group.stars) {
		ranked.emplace_back(rank_of(table.stars[index], planck), index);
	}
	std::sort(ranked.begin(), ranked.end());
	group.ranks.reserve(ranked.size());
	for (std::size_t i = 0; i < ranked.size(); ++i) {
		group.ranks.push_back(ranked[i].first);
		group.stars[i] = ranked[i].second;
	}
}

void bound(const StarTable &table, const std::vector<glm::dvec3> &directions, const PlanckTable &planck,
		StarGroup &group) {
	glm::dvec3 sum(0.0);
	float coolest = table.stars[group.stars.front()].temperature_k;
	float hottest = coolest;
	for (const std::uint32_t index : group.stars) {
		sum += directions[index];
		coolest = std::min(coolest, table.stars[index].temperature_k);
		hottest = std::max(hottest, table.stars[index].temperature_k);
	}
	const double length = glm::length(sum);
	group.centre = length > 0.0 ? sum / length : glm::dvec3(1.0, 0.0, 0.0);
	double nearest_cosine = 1.0;
	for (const std::uint32_t index : group.stars) {
		nearest_cosine = std::min(nearest_cosine, glm::dot(group.centre, directions[index]));
	}
	group.angular_radius = std::acos(std::clamp(nearest_cosine, -1.0, 1.0)) + 1e-9;
	group.shift = ShiftBound(coolest, hottest, planck, kRankingShift);
}

} // namespace

std::vector<StarGroup> group_stars(
		const StarTable &table, const std::vector<glm::dvec3> &directions, const PlanckTable &planck) {
	const std::size_t count = table.stars.size();
	std::vector<std::uint16_t> cell_of_star(count);
	parallel_for(count, kPiece, [&](std::size_t first, std::size_t end) {
		for (std::size_t i = first; i < end; ++i) {
			cell_of_star[i] = static_cast<std::uint16_t>(cell_of(directions[i]));
		}
	});
	std::vector<StarGroup> groups(std::size_t{6} * kDivisions * kDivisions);
	std::vector<std::size_t> sizes(groups.size());
	for (const std::uint16_t cell : cell_of_star) {
		++sizes[cell];
	}
	for (std::size_t cell = 0; cell < groups.size(); ++cell) {
		groups[cell].stars.reserve(sizes[cell]);
	}
	for (std::size_t i = 0; i < count; ++i) {
		groups[cell_of_star[i]].stars.push_back(static_cast<std::uint32_t>(i));
	}
	std::erase_if(groups, [](const StarGroup &group) { return group.stars.empty(); });
	parallel_for(
			groups.size(), 1 + kPiece * groups.size() / (count + 1), [&](std::size_t first, std::size_t end) {
				for (std::size_t i = first; i < end; ++i) {
					rank(table, planck, groups[i]);
					bound(table, directions, planck, groups[i]);
				}
			});
	return groups;
}

std::vector<glm::dvec3> star_directions(const StarTable &table) {
	std::vector<glm::dvec3> directions(table.stars.size());
	parallel_for(directions.size(), kPiece, [&](std::size_t first, std::size_t end) {
		for (std::size_t i = first; i < end; ++i) {
			directions[i] = world_direction(table.stars[i]);
		}
	});
	return directions;
}

} // namespace blackhole
