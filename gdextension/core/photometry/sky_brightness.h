// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include <glm/vec3.hpp>

#include "core/catalogue/star.h"
#include "core/overlay/cube_map.h"

namespace blackhole {

/// The mean light of each part of the sky, for exposure meters: a small cube map of luminance on the one
/// radiometric scale (radiometry.h, exposure 0) and of the temperature that the light has as a black body's.
///
/// Lensing and aberration conserve surface brightness but for the shift of frequencies. So an observer who
/// sees this light with every frequency multiplied by g sees luminance * Y(g T)/Y(T), Y from PlanckTable.
class SkyBrightness {
public:
	/// Cells along a side of a face: 5.6 degrees in its middle. Finer ones would only make single stars
	/// count.
	static constexpr int kSize = 16;

	struct Light {
		float luminance = 0.0F;
		float temperature = 5772.0F; ///< kelvin, the mean weighted by luminance
	};

	/// A dark sky.
	SkyBrightness() = default;
	/// The stars (brightest first) up to a V magnitude, each as its light over the solid angle of its cell.
	static SkyBrightness of_stars(const StarTable &p_table, double p_faintest);
	/// A panorama: linear Rec.709, three floats a texel, equirectangular with u = frac(0.25 - RA/360 deg),
	/// v = (90 deg - Dec)/180 deg. A texel of 1 has luminance 1.
	static SkyBrightness of_panorama(const float *p_rgb, int p_columns, int p_rows);

	/// The light of the cell in which a direction lies: sky axes, any length but 0.
	Light at(const glm::dvec3 &p_direction) const { return m_cells[cell(p_direction)]; }

private:
	static constexpr std::size_t kCells = std::size_t{kCubeFaces} * kSize * kSize;

	/// Sums over each cell, of which the means are taken.
	struct Sums {
		std::array<double, kCells> light{};       ///< luminance times solid angle
		std::array<double, kCells> heat{};        ///< that times temperature
		std::array<double, kCells> solid_angle{}; ///< sr, over which the light is spread
	};
	static std::size_t cell(const glm::dvec3 &p_direction);
	static SkyBrightness means(const Sums &p_sums);

	std::array<Light, kCells> m_cells;
};

/// Temperature in kelvin, 2000 to 30000, of the black body whose blue and red (linear Rec.709) stand in this
/// proportion: colour_temperature() of colour.gdshaderinc.
double colour_temperature(double p_red, double p_blue);

} // namespace blackhole
