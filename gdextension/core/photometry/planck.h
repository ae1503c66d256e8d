// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace blackhole {

/// Weights of linear Rec.709 red, green and blue in the luminance.
inline constexpr glm::dvec3 kLuminanceWeights = {0.2126390058715104, 0.7151686787677559, 0.0721923153607337};

/// Light of a black body as the CIE 1931 2-degree observer sees it.
struct PlanckLight {
	/// Natural logarithm of the luminance in cd/m2: +infinity for infinite temperature.
	double ln_luminance;
	/// CIE 1931 tristimulus values over their Y: (x/y, 1, z/y).
	glm::dvec3 xyz;
};

/// Planck's law integrated with the colour matching functions. p_temperature in kelvin, from 10 K to
/// infinity. The sum is taken relative to the reddest wavelength, so nothing underflows at low temperatures.
/// Source: CIE 15:2018; checked to 4 decimals of log10 Y and 6 of x, y.
PlanckLight planck_light(double p_temperature);

/// log10 of the luminance in cd/m2 of a black body of p_temperature kelvin (10 K to below infinity).
double planck_luminance_log10(double p_temperature);

/// CIE 1931 (x, y) of a black body of p_temperature kelvin (10 K to infinity).
glm::dvec2 planck_chromaticity(double p_temperature);

/// Linear Rec.709 of a black body of p_temperature kelvin (10 K to infinity), of luminance 1. A colour
/// outside the gamut (below 1900 K) is mixed with white of the same luminance until no component is negative.
glm::dvec3 planck_rgb(double p_temperature);

/// p_xyz as in PlanckLight in linear Rec.709 (white D65) of luminance 1; components below 0 lie outside the
/// gamut.
glm::dvec3 rec709_of_xyz(glm::dvec3 p_xyz);

/// p_rgb, of luminance 1, mixed with white (1, 1, 1) just so far that no component is negative.
glm::dvec3 desaturated(glm::dvec3 p_rgb);

} // namespace blackhole
