// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

#include "core/catalogue/star.h"
#include "core/culling/star_groups.h"
#include "core/photometry/planck_table.h"

namespace blackhole {

/// Floats of one star's row, 48 bytes: the instance transform that star_layer.gdshaderinc reads, three rows
/// of basis and origin.
inline constexpr std::size_t kFloatsPerStar = 12;

/// Writes the rows of a group's stars, in its order, to `rows` (kFloatsPerStar for each star). `directions`
/// are those of the whole table.
void pack_rows(const StarTable &table, const std::vector<glm::dvec3> &directions, const StarGroup &group,
		const PlanckTable &planck, float *rows);

} // namespace blackhole
