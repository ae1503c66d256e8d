// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

namespace blackhole {

/// The grid of the lensing tables. Columns: x in [0, 1] uniformly, x = 1/2 + X/(2 sqrt(X^2 + 25)), where X is
/// the logarithm of a quantity over its value at the Einstein ring; X is clamped to +-60, where nothing
/// changes any more. Rows: ln u uniformly.
inline constexpr int kTableColumns = 128;
inline constexpr int kTableRows = 96;
inline constexpr double kTableUMin = 1e-8;
inline constexpr double kTableUMax = 25.0;
inline constexpr double kTableXLimit = 60.0;
/// The square of the scale of X in the compression to x.
inline constexpr double kTableXScaleSquared = 25.0;

/// A column's X and the slope of the compression there.
struct ColumnPlace {
	double big_x = 0.0;
	/// dX/dx; 0 at the clamped ends, where the tabulated function has reached its limit.
	double slope = 0.0;
};

/// The place of column index 0 .. columns - 1.
inline ColumnPlace column_place(int index, int columns) {
	const double s = 2.0 * index / (columns - 1.0) - 1.0;
	if (index <= 0 || index >= columns - 1) {
		return {index <= 0 ? -kTableXLimit : kTableXLimit, 0.0};
	}
	const double big_x = std::sqrt(kTableXScaleSquared) * s / std::sqrt(1.0 - s * s);
	const double h2 = big_x * big_x + kTableXScaleSquared;
	return {big_x, 2.0 * h2 * std::sqrt(h2) / kTableXScaleSquared};
}

} // namespace blackhole
