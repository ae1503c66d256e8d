// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

namespace blackhole {

/// CIE 1931 colour matching functions of the 2-degree standard observer at one wavelength.
struct ColourMatch {
	double x, y, z;
};

inline constexpr std::size_t kCieSamples = 471;
inline constexpr double kCieFirstNm = 360.0; ///< wavelength of the first sample, nanometres
inline constexpr double kCieStepNm = 1.0;

/// From 360 to 830 nm, every nanometre. CIE 018:2019, table 6; values as in colour-science 0.4.7.
extern const std::array<ColourMatch, kCieSamples> kCie1931;

} // namespace blackhole
