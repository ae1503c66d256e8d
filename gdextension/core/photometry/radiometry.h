// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec2.hpp>

#include "core/photometry/planck_table.h"

// The one radiometric scale: stars, the Milky Way and the disk keep their proportion at every resolution and
// field of view. L is linear luminance of the picture at exposure 0, where 1 is the white of the screen.
//   star of magnitude V:                 sum over its pixels of L = K (Omega_ref/Omega_px) 10^(-0.4 V)
//   surface of mu magnitudes/arcsec^2:   L = K Omega_ref/(1 arcsec^2) 10^(-0.4 mu)
//   black body's surface:                L = Y(T)/Y(T_sun) K Omega_ref/Omega_sun 10^(-0.4 V_sun)
namespace blackhole {

/// K: the sum of a star of magnitude 0 over its pixels in the reference view.
inline constexpr double kStarGain = 30.0;
/// Omega_ref in steradians: the central pixel of 720 rows over 60 degrees, (2 tan(30 deg)/720)^2 = 1/388800.
inline constexpr double kReferenceSolidAngle = 1.0 / 388800.0;
/// One square second of arc in steradians.
inline constexpr double kSquareArcsecond = 2.3504430539097885e-11;

/// What the linear texels of data/milky_way.exr are multiplied by to lie on this scale: the logarithmic mean
/// over six fields of known surface brightness, from 0.05 to 0.47 because the picture's contrast is stretched
/// (tools/milky_way/README.md).
inline constexpr double kMilkyWayScale = 0.147;

/// Solid angle in steradians of a square pixel of a flat picture p_rows high that spans p_vertical_fov
/// radians (0 to pi), where the picture plane at distance 1 is pierced at p_tangent (0, 0 on the axis; |y| up
/// to tan(fov/2)).
double pixel_solid_angle(double p_vertical_fov, int p_rows, glm::dvec2 p_tangent = glm::dvec2(0.0));

/// Sum over its pixels of the luminance of an unlensed star of p_v_magnitude, p_pixel_solid_angle in
/// steradians; a lensed star's is mu Y(gT)/Y(T) times that.
double star_luminance_sum(double p_v_magnitude, double p_pixel_solid_angle);

/// Luminance of a surface of p_magnitude in V per square second of arc.
double surface_luminance(double p_magnitude);

/// log2 of the picture luminance of a surface whose luminance is 1 cd/m2 (Y of the Planck table), on the same
/// scale: the Sun's disk has the light of the star that it is.
double log2_luminance_unit();

/// Apparent radius in radians of a star of p_v_magnitude that shines as a black body of p_temperature kelvin:
/// the Sun's, scaled by the flux and by the surface brightness. It bounds the magnification of a star behind
/// the hole.
double star_angular_radius(double p_v_magnitude, double p_temperature, const PlanckTable &p_planck);

} // namespace blackhole
