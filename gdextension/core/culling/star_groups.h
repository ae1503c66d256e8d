// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "core/catalogue/star.h"
#include "core/culling/shift_bound.h"
#include "core/photometry/planck_table.h"

namespace blackhole {

/// Stars are ranked by how bright they would be with all frequencies raised by this factor, a typical one
/// where images are many: then fewer stars that stay too faint come before the ones that are seen.
inline constexpr double kRankingShift = 1.06;

/// The stars in one part of the sky, brightest first: of each group the brightest are drawn, as many as can
/// be seen.
struct StarGroup {
	glm::dvec3 centre{0.0};           ///< unit vector, ICRS axes
	double angular_radius = 0.0;      ///< radians; every star lies within it of the centre
	ShiftBound shift;                 ///< what a shift of frequencies does at most, beyond kRankingShift
	std::vector<std::uint32_t> stars; ///< places in StarTable::stars, by rising rank
	/// Their ranks: V magnitude less the gain by kRankingShift, so never above V.
	std::vector<float> ranks;
};

/// Divides a catalogue (brightest first) into at most 150 groups: twenty-fifths of the faces of a cube round
/// the observer. More were no gain even with 2.5 million stars: as many drawn, and twice the work before each
/// frame. `directions` are the stars' unit vectors. A star belongs to one group only. Takes time in
/// proportion to the stars, on all processors.
std::vector<StarGroup> group_stars(
		const StarTable &table, const std::vector<glm::dvec3> &directions, const PlanckTable &planck);

/// The stars' unit vectors, in world axes.
std::vector<glm::dvec3> star_directions(const StarTable &table);

} // namespace blackhole
