// SPDX-License-Identifier: MIT
#pragma once

#include "core/tables/ray_axis.h"
#include "core/tables/ray_tables.h"

#include <vector>

namespace blackhole {

/// For the graphics device a ray table is sampled so densely that the plane through the nearest sample does
/// between them: a pixel reads one texel instead of four. So many parts each step of the table has.
inline constexpr int kRayColumnParts = 4;
inline constexpr int kRayRowParts = 6;
inline constexpr int kRayTexelColumns = (kRayColumns - 1) * kRayColumnParts + 1;
inline constexpr int kRayTexelHalfRows = (kRayHalfRows - 1) * kRayRowParts + 1;
inline constexpr int kRayTexelRows = 2 * kRayTexelHalfRows;

/// RGBA texels, row-major, kRayTexelColumns x kRayTexelRows: value, d/d column, d/d row, both, each step
/// being one of this denser grid.
struct RayTexels {
	std::vector<float> radius;
	std::vector<float> delay;
};

/// Sampled from the tables by their own interpolation; empty if they are.
RayTexels sample_ray_tables(const RayTables &tables);

} // namespace blackhole
