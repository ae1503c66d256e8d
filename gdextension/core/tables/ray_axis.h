// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <numbers>

namespace blackhole {

/// The grid of the ray tables (ray_tables.h), which hold what happens along light rays that come from
/// infinity. Columns name the ray: with x = a/a_c for those that turn (a < a_c) and a_c/a for those that
/// plunge, L = -ln(1
/// - x) counts how near the ray is to the critical one, and columns are uniform in ln(1 + L/L_0). Rows, the
/// first half for rays that turn, the second for those that plunge: the angle eta from infinity, uniformly
/// from 0 to ray_span().
inline constexpr int kRayColumns = 96;
inline constexpr int kRayHalfRows = 64;
inline constexpr int kRayRows = 2 * kRayHalfRows;
/// Of the last column: |a/a_c - 1| = 1e-7, below what single precision tells apart.
inline constexpr double kRayNearest = 16.0;
/// L_0: plunging rays of small L, nearly straight, end soonest.
inline constexpr double kRayBend = 0.03;

/// L of a column, 0 to kRayColumns - 1.
inline double ray_column_nearness(int column) {
	return kRayBend * std::expm1(column / (kRayColumns - 1.0) * std::log1p(kRayNearest / kRayBend));
}

/// dL/d(column).
inline double ray_column_slope(int column) {
	return std::log1p(kRayNearest / kRayBend) / (kRayColumns - 1.0) *
			(kRayBend + ray_column_nearness(column));
}

/// The fit to where plunging rays end: L (1 + sum of height/(L + bend)).
struct RaySpanTerm {
	double height;
	double bend;
};
inline constexpr RaySpanTerm kRaySpanNearlyStraight{0.807, 0.0082};
inline constexpr RaySpanTerm kRaySpanBent{3.086, 0.374};

/// Where the rows end: an angle [rad] a little beyond the turning point, or where a plunging ray has come to
/// r = r_s/20 or deeper, short of the singularity (a fit to that angle). With its derivative by L.
struct RaySpan {
	double eta = 0.0;
	double slope = 0.0;
};

inline RaySpan ray_span(bool turns, double nearness) {
	if (turns) {
		return {0.5 * (std::numbers::pi + nearness), 0.5};
	}
	const auto &[straight_height, straight_bend] = kRaySpanNearlyStraight;
	const auto &[bent_height, bent_bend] = kRaySpanBent;
	const double straight = nearness + straight_bend;
	const double bent = nearness + bent_bend;
	return {nearness * (1.0 + straight_height / straight + bent_height / bent),
			1.0 + straight_height * straight_bend / (straight * straight) +
					bent_height * bent_bend / (bent * bent)};
}

} // namespace blackhole
