// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

namespace blackhole {

/// B-V in magnitudes of a black body of p_temperature kelvin (> 0): energy-weighted mean of the Planck
/// spectrum through the B and V passbands of Bessell 1990 (PASP 102, 1181), zero point of Bessell, Castelli &
/// Plez 1998 (A&A 333, 231, table A2).
double black_body_b_minus_v(double p_temperature);

/// The temperature of the black body that has a star's observed B-V: the inverse of black_body_b_minus_v.
///
/// A star is drawn as a Planck source of one temperature. Taking the temperature whose Planck colour is the
/// observed one keeps the star's colour as observed (Sirius, B-V 0.009: 12,800 K), where the effective
/// temperature (Sirius: 9,940 K) would make every star too red. The price: the temperature is a colour
/// temperature, not that of the star's photosphere, and interstellar reddening is taken for coolness, as the
/// eye takes it.
class ColourTemperature {
public:
	/// The range of the answers in kelvin. Below 1900 K no screen shows a redder Planck colour; above 40,000
	/// K a hundredth of a magnitude in B-V would decide over ten thousand kelvin without a visible change of
	/// colour.
	static constexpr double kCoolest = 1900.0;
	static constexpr double kHottest = 40000.0;

	ColourTemperature();
	/// Kelvin, within 0.5 K + 1e-4 of the exact inverse and clamped to [kCoolest, kHottest]; p_b_minus_v is
	/// finite.
	double operator()(double p_b_minus_v) const;

private:
	static constexpr std::size_t kNodes = 256;
	std::array<double, kNodes> m_colour{}; // falling, at temperatures rising evenly in their logarithm
};

/// Effective temperature in kelvin of a star of colour p_b_minus_v (clamped to [-0.4, 2]), Ballesteros 2012
/// (EPL 97, 34008): T = 4600 (1/(0.92 x + 1.7) + 1/(0.92 x + 0.62)). For comparison and for labels.
double ballesteros_temperature(double p_b_minus_v);

} // namespace blackhole
