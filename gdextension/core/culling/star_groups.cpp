// SPDX-License-Identifier: MIT
#include "core/culling/star_groups.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

#include <glm/geometric.hpp>

#include "core/parallel.h"

namespace blackhole {
namespace {

constexpr int kDivisions = 5; // cells along a cube face's edge; division_of() has their bounds
constexpr std::size_t kCells = std::size_t{6} * kDivisions * kDivisions;
constexpr std::size_t kCellsPerPiece = 10;
constexpr std::size_t kPiece = 16384; // stars that make a thread worth while

int division_of(double coordinate) {
	// Equal angles rather than equal lengths, so that cells are of like size: the bounds are tan(9), tan(27
	// deg).
	constexpr double kInner = 0.15838444032453629;
	constexpr double kOuter = 0.50952544949442881;
	return (coordinate >= -kOuter ? 1 : 0) + (coordinate >= -kInner ? 1 : 0) +
			(coordinate >= kInner ? 1 : 0) + (coordinate >= kOuter ? 1 : 0);
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

using Ranked = std::vector<std::pair<float, std::uint32_t>>; // rank and place in the table

/// What is found out of a cell while going through the table.
struct Cell {
	std::size_t stars = 0;
	glm::dvec3 sum = glm::dvec3(0.0); ///< of the directions
	glm::dvec3 centre = glm::dvec3(1.0, 0.0, 0.0);
	double nearest_cosine = 1.0;
	float coolest = std::numeric_limits<float>::infinity();
	float hottest = 0.0F;
	Ranked ranked;
};

/// For each star, its cell and its rank.
void classify(const StarTable &table, const std::vector<glm::dvec3> &directions, const PlanckTable &planck,
		std::vector<std::uint8_t> &cells, std::vector<float> &ranks) {
	cells.resize(table.stars.size());
	ranks.resize(table.stars.size());
	parallel_for(table.stars.size(), kPiece, [&](std::size_t first, std::size_t end) {
		for (std::size_t i = first; i < end; ++i) {
			cells[i] = static_cast<std::uint8_t>(cell_of(directions[i]));
			ranks[i] = rank_of(table.stars[i], planck);
		}
	});
}

/// Sorts the stars into their cells. The table is read from end to end each time: millions of stars do not
/// fit a processor's cache, and jumping about in them would take several times as long.
std::vector<Cell> fill_cells(
		const StarTable &table, const std::vector<glm::dvec3> &directions, const PlanckTable &planck) {
	std::vector<std::uint8_t> cell_of_star;
	std::vector<float> ranks;
	classify(table, directions, planck, cell_of_star, ranks);
	std::vector<Cell> cells(kCells);
	for (std::size_t i = 0; i < ranks.size(); ++i) {
		Cell &cell = cells[cell_of_star[i]];
		++cell.stars;
		cell.sum += directions[i];
		cell.coolest = std::min(cell.coolest, table.stars[i].temperature_k);
		cell.hottest = std::max(cell.hottest, table.stars[i].temperature_k);
	}
	for (Cell &cell : cells) {
		const double length = glm::length(cell.sum);
		cell.centre = length > 0.0 ? cell.sum / length : cell.centre;
		cell.ranked.reserve(cell.stars);
	}
	for (std::size_t i = 0; i < ranks.size(); ++i) {
		Cell &cell = cells[cell_of_star[i]];
		cell.nearest_cosine = std::min(cell.nearest_cosine, glm::dot(cell.centre, directions[i]));
		cell.ranked.emplace_back(ranks[i], static_cast<std::uint32_t>(i));
	}
	return cells;
}

StarGroup group_of(Cell &cell, const PlanckTable &planck) {
	std::sort(cell.ranked.begin(), cell.ranked.end());
	StarGroup group;
	group.stars.reserve(cell.stars);
	group.ranks.reserve(cell.stars);
	for (const auto &[rank, star] : cell.ranked) {
		group.ranks.push_back(rank);
		group.stars.push_back(star);
	}
	group.centre = cell.centre;
	group.angular_radius = std::acos(std::clamp(cell.nearest_cosine, -1.0, 1.0)) + 1e-9;
	group.shift = ShiftBound(cell.coolest, cell.hottest, planck, kRankingShift);
	return group;
}

} // namespace

std::vector<StarGroup> group_stars(
		const StarTable &table, const std::vector<glm::dvec3> &directions, const PlanckTable &planck) {
	std::vector<Cell> cells = fill_cells(table, directions, planck);
	std::erase_if(cells, [](const Cell &cell) { return cell.stars == 0; });
	std::vector<StarGroup> groups(cells.size());
	parallel_for(groups.size(), kCellsPerPiece, [&](std::size_t first, std::size_t end) {
		for (std::size_t i = first; i < end; ++i) {
			groups[i] = group_of(cells[i], planck);
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
