// SPDX-License-Identifier: MIT
#include "core/tables/lensing_tables.h"

#include "core/relativity/baseline.h"
#include "core/relativity/image_direction.h"
#include "core/relativity/orbital_angle.h"
#include "core/tables/table_axis.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace blackhole {
namespace {

/// A table's value at one node with its logarithmic slopes in X (at fixed u) and in v = ln u (at fixed X).
struct Node {
	double value = 0.0;
	double log_slope_x = 0.0;
	double log_slope_v = 0.0;
};

/// What all nodes of a row share.
struct RowPlace {
	double u = 0.0;
	/// w and d ln w/dv.
	double w = 0.0;
	double w_slope = 0.0;

	explicit RowPlace(double ln_u) : u(std::exp(ln_u)) {
		const auto width = baseline_width(Dual<1>::variable(u, 0));
		w = width.value;
		w_slope = u * width.slope[0] / w;
	}
};

/// R = y/S0 at S0 = sqrt(w/2) e^X.
Node inverse_node(const RowPlace &row, double big_x) {
	const double s0 = std::sqrt(0.5 * row.w) * std::exp(big_x);
	const double phi = angle_of_baseline(row.w, s0);
	const Baseline at = baseline(row.w, phi);
	const double y = image_direction(row.u, phi).y;
	const OrbitalAngle angle = orbital_angle_slopes(row.u, y);
	// Along X: t = 2 sqrt(w/2) sinh X, so dt/dX = q. Along v: t, S0 and q grow like sqrt(w).
	const double phi_x = at.q / at.t_slope;
	const double phi_v = 0.5 * row.w_slope * at.t / at.t_slope;
	const double log_y_phi = 1.0 / (y * angle.slope_y);
	return {y / s0, log_y_phi * phi_x - 1.0, log_y_phi * (phi_v - row.u * angle.slope_u) - 0.5 * row.w_slope};
}

/// Q = S0/y at y = sqrt(w/2) e^X.
Node forward_node(const RowPlace &row, double big_x) {
	const double y = std::sqrt(0.5 * row.w) * std::exp(big_x);
	const OrbitalAngle angle = orbital_angle_slopes(row.u, y);
	const Baseline at = baseline(row.w, angle.phi);
	const double log_s0_phi = at.t_slope / at.q;
	const double phi_v = row.u * angle.slope_u + 0.5 * row.w_slope * y * angle.slope_y;
	return {at.s0 / y, log_s0_phi * angle.slope_y * y - 1.0,
			log_s0_phi * phi_v + row.w_slope * (row.w / (2.0 * at.q * at.s0) - 0.5)};
}

/// Derivative by the column index, of sixth order where both sides have three neighbours.
double column_slope(const std::array<double, kTableColumns> &values, std::size_t index) {
	const auto at = [place = values.begin() + static_cast<std::ptrdiff_t>(index)](
							int offset) { return place[offset]; };
	if (index == 0 || index == kTableColumns - 1) {
		return 0.0;
	}
	if (index < 3 || index > kTableColumns - 4) {
		return 0.5 * (at(1) - at(-1));
	}
	return 0.75 * (at(1) - at(-1)) - 0.15 * (at(2) - at(-2)) + (at(3) - at(-3)) / 60.0;
}

/// Fills one row of texels from the nodes.
template <class NodeFunction>
void bake_row(NodeFunction node_at, const RowPlace &row, double v_step, float *texels) {
	const double x_step = 1.0 / (kTableColumns - 1.0);
	std::array<double, kTableColumns> v_slopes{};
	for (std::size_t column = 0; column < kTableColumns; ++column) {
		const ColumnPlace place = column_place(static_cast<int>(column), kTableColumns);
		const Node node = node_at(row, place.big_x);
		v_slopes[column] = node.value * node.log_slope_v * v_step;
		texels[4 * column] = static_cast<float>(node.value);
		texels[4 * column + 1] = static_cast<float>(node.value * node.log_slope_x * place.slope * x_step);
		texels[4 * column + 2] = static_cast<float>(v_slopes[column]);
	}
	for (std::size_t column = 0; column < kTableColumns; ++column) {
		texels[4 * column + 3] = static_cast<float>(column_slope(v_slopes, column));
	}
}

/// Of the whole work, the part that the tables of the sky are.
constexpr double kSkyShare = 0.5;

} // namespace

LensingTables bake_lensing_tables(const std::function<bool(double)> &progress) {
	LensingTables tables{kTableColumns, kTableRows, std::log(kTableUMin), std::log(kTableUMax), kTableXLimit,
			{}, {}, {}, {}};
	constexpr std::size_t kRowFloats = std::size_t{4} * kTableColumns;
	tables.inverse.resize(kRowFloats * kTableRows);
	tables.forward.resize(kRowFloats * kTableRows);
	const double v_step = (tables.ln_u_max - tables.ln_u_min) / (kTableRows - 1.0);
	for (int row = 0; row < kTableRows; ++row) {
		if (progress && !progress(kSkyShare * row / kTableRows)) {
			return {};
		}
		const RowPlace place(tables.ln_u_min + row * v_step);
		const std::size_t start = kRowFloats * static_cast<std::size_t>(row);
		bake_row(inverse_node, place, v_step, tables.inverse.data() + start);
		bake_row(forward_node, place, v_step, tables.forward.data() + start);
	}
	tables.rays = bake_ray_tables(
			[&progress](double done) { return !progress || progress(kSkyShare + (1.0 - kSkyShare) * done); });
	if (tables.rays.radius.empty()) {
		return {};
	}
	tables.ray_texels = sample_ray_tables(tables.rays);
	return tables;
}

} // namespace blackhole
