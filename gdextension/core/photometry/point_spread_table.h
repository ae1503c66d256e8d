// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "core/photometry/point_spread.h"

namespace blackhole {

/// A pattern as addons/blackhole_sky/shaders/star_profile.gdshaderinc reads it, at every ratio of its scale
/// to the pixel's.
///
/// A pattern of scale s pixels (x = 1) is convolved with a Gaussian of sigma pixels, the finest that pixels
/// can show. With w^2 = s^2 + sigma^2 it depends on the radius t = r/w and on v = s/w alone: v = 0 is the
/// Gaussian, v = 1 the bare pattern. Nodes: rows at v = j/(kRows - 1); columns i with q = i/(kColumns - 1).
/// Three blocks:
///  0  light per unit area of t, at t = kReach (kNearPart q + (1 - kNearPart) q^2): its integral is 1;
///  1  its integral within t when it is faded out towards t by fade();
///  2  the radius at which to cut a star off, by contrast = light/(limit w^2) = 2^(kOctaves q), "limit" being
///     the luminance of a pixel that is no longer seen.
/// Linear interpolation over rows and columns. Block 0 conserves light exactly between rows.
class PointSpreadTable {
public:
	static constexpr std::size_t kColumns = 512;
	static constexpr std::size_t kRows = 17;
	static constexpr std::size_t kBlocks = 3;
	static constexpr double kReach = 128.0; ///< largest t
	static constexpr double kNearPart = 0.1;
	static constexpr double kOctaves = 32.0;

	/// p_glare (0 to 1): share of the light in the wings of the eye; of no account for other patterns. The
	/// first of a pattern takes some 100 ms, others of the eye a few. A Gaussian is the row of v = 0
	/// throughout.
	PointSpreadTable(PointSpread p_model, double p_glare);

	/// How a star's light at the fraction p_part (0 to 1) of its cut radius is reduced: 1 up to the half, 0
	/// at the whole, with level slopes at both.
	static double fade(double p_part);

	double profile(double p_t, double p_v) const { return at(0, column_of(p_t), p_v); }
	double faded_light(double p_t, double p_v) const { return at(1, column_of(p_t), p_v); }
	double cut_radius(double p_contrast, double p_v) const;

	/// RGBA texels, kColumns wide and kBlocks (kRows - 1) high: each holds the nodes (i, j), (i + 1, j),
	/// (i, j + 1), (i + 1, j + 1) of a cell, so that a look-up is one texel. The last column repeats.
	std::vector<float> texels() const;

private:
	static double column_of(double p_t);
	double node(std::size_t p_block, std::size_t p_column, std::size_t p_row) const {
		return m_nodes[(p_block * kRows + p_row) * kColumns + p_column];
	}
	double at(std::size_t p_block, double p_column, double p_v) const;
	void add_faded_light(std::size_t p_row);
	void add_cut_radii(std::size_t p_row);

	std::vector<double> m_nodes;
};

} // namespace blackhole
