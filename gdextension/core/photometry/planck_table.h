// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

namespace blackhole {

/// Texels of the Planck table: a texture kPlanckTableSize wide and 1 high, RGBA, 32-bit floats.
inline constexpr std::size_t kPlanckTableSize = 512;

/// The colour and luminance of black bodies, as addons/blackhole_sky/shaders/planck.gdshaderinc reads it.
///
/// Texel i lies at s = i/(size - 1), with s = (kCoolest + kKnee)/(T + kKnee): T infinite at s = 0 and 250 K
/// at s = 1; cooler bodies keep the last texel. It holds linear Rec.709 of luminance 1, with negative
/// components where the colour lies outside the gamut (the shader desaturates after interpolating, which
/// keeps the corners sharp), and
///   w = log2 Y - (log2(1 + T/theta) - log2(e) theta/T),  Y in cd/m2,
/// whose second part has the right slope at both ends, so the remainder is smooth and finite at infinite T.
/// Linear interpolation keeps luminance 1. From 500 K to 1e6 K: Y within 0.02 %, (x, y) within 0.00005.
class PlanckTable {
public:
	static constexpr double kCoolest = 250.0; ///< kelvin
	static constexpr double kKnee = 1500.0;   ///< kelvin
	static constexpr double kTheta = 23206.0; ///< kelvin; a wavelength of 620 nm

	/// Bakes the table: a few milliseconds.
	PlanckTable();

	/// 4 * kPlanckTableSize floats, texel after texel.
	const std::vector<float> &texels() const { return m_texels; }
	/// log2 of the luminance in cd/m2 of a black body of p_temperature kelvin (> 0), interpolated.
	double log2_luminance(double p_temperature) const;

private:
	std::vector<float> m_texels;
};

/// The texels of a fresh PlanckTable.
std::vector<float> bake_planck_table();

} // namespace blackhole
