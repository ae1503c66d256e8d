// SPDX-License-Identifier: MIT
#include "core/tables/ray_texels.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace blackhole {
namespace {

/// Cubic Hermite interpolation at the part f of a step: weights of value and slope at its start and its end,
/// for the value and for its derivative.
struct Hermite {
	std::array<float, 4> value{};
	std::array<float, 4> slope{};

	explicit Hermite(float f) {
		const float e = 1.0F - f;
		const float bend = 6.0F * f * (f - 1.0F);
		value = {e * e * (1.0F + 2.0F * f), f * e * e, f * f * (3.0F - 2.0F * f), -f * f * e};
		slope = {bend, e * (1.0F - 3.0F * f), -bend, f * (3.0F * f - 2.0F)};
	}
};

/// One axis of the denser grid: the step of the table in which a sample lies and where.
struct Place {
	std::size_t step;
	Hermite weights;

	Place(int sample, int parts, int nodes)
			: step(static_cast<std::size_t>(std::min(sample / parts, nodes - 2))),
			  weights(static_cast<float>(sample - static_cast<int>(step) * parts) /
					  static_cast<float>(parts)) {}
};

/// The table at a sample; `half`: its rows for rays of this kind.
void put_texel(const float *half, const Place &column, const Place &row, std::vector<float> &texels) {
	// By the columns: value and slope of (value, d/d row), at both rows.
	std::array<std::array<float, 4>, 2> along{};
	std::array<std::array<float, 4>, 2> along_slope{};
	for (std::size_t below = 0; below < 2; ++below) {
		const float *left = half + 4 * ((row.step + below) * kRayColumns + column.step);
		const float *right = left + 4;
		for (std::size_t by_row = 0; by_row < 2; ++by_row) {
			const std::size_t value = 2 * by_row;
			const std::array<float, 4> ends{left[value], left[value + 1], right[value], right[value + 1]};
			for (std::size_t i = 0; i < 4; ++i) {
				along[below][by_row] += column.weights.value[i] * ends[i];
				along_slope[below][by_row] += column.weights.slope[i] * ends[i];
			}
		}
	}
	const auto across = [](const std::array<float, 4> &weights,
								const std::array<std::array<float, 4>, 2> &ends) {
		return weights[0] * ends[0][0] + weights[1] * ends[0][1] + weights[2] * ends[1][0] +
				weights[3] * ends[1][1];
	};
	constexpr float kColumnStep = 1.0F / kRayColumnParts;
	constexpr float kRowStep = 1.0F / kRayRowParts;
	texels.insert(texels.end(),
			{across(row.weights.value, along), kColumnStep * across(row.weights.value, along_slope),
					kRowStep * across(row.weights.slope, along),
					kColumnStep * kRowStep * across(row.weights.slope, along_slope)});
}

std::vector<float> sample(const std::vector<float> &table) {
	std::vector<float> texels;
	if (table.empty()) {
		return texels;
	}
	texels.reserve(std::size_t{4} * kRayTexelColumns * kRayTexelRows);
	std::vector<Place> columns;
	columns.reserve(kRayTexelColumns);
	for (int column = 0; column < kRayTexelColumns; ++column) {
		columns.emplace_back(column, kRayColumnParts, kRayColumns);
	}
	for (std::size_t half = 0; half < 2; ++half) {
		const float *start = table.data() + 4 * half * kRayHalfRows * kRayColumns;
		for (int row = 0; row < kRayTexelHalfRows; ++row) {
			const Place row_place(row, kRayRowParts, kRayHalfRows);
			for (const Place &column_place : columns) {
				put_texel(start, column_place, row_place, texels);
			}
		}
	}
	return texels;
}

} // namespace

RayTexels sample_ray_tables(const RayTables &tables) {
	return {sample(tables.radius), sample(tables.delay)};
}

} // namespace blackhole
