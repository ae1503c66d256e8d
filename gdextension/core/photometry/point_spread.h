// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec3.hpp>

// How the light of a star spreads, as round patterns over a scaled radius x. A profile is light per unit area
// of the plane in which x is the radius, so that its integral over that plane is 1; the encircled light is
// the share within x.
namespace blackhole {

/// Which pattern a star is drawn as.
enum class PointSpread { kGaussian, kAiry, kEye };

/// Wavelengths in metres that stand for linear Rec.709 red, green and blue in diffraction: the dominant
/// wavelengths of the primaries, seen from white D65, by the CIE 1931 observer.
inline constexpr glm::dvec3 kChannelWavelengths = {611.4e-9, 549.1e-9, 464.3e-9};

/// Fraunhofer diffraction by a circular aperture of diameter D: x = pi D theta/lambda. First zero at
/// x = 3.8317, theta = 1.2197 lambda/D.
double airy_profile(double p_x);
/// Rayleigh's 1 - J0(x)^2 - J1(x)^2.
double airy_encircled(double p_x);
/// The angle in radians of x = 1 for each channel, aperture diameter in metres (> 0).
glm::dvec3 airy_angles(double p_aperture);

// The eye that sees by day: Spencer, Shirley, Zimmerman & Greenberg 1995, "Physically-Based Glare Effects for
// Digital Images", photopic point spread 0.384 f0 + 0.478 f1 + 0.138 f2 after Vos 1984; x = theta/0.02
// degrees.

/// The angle in radians of x = 1: 0.02 degrees.
inline constexpr double kEyeAngle = 3.490658503988659e-4;
/// Share of the light in the published wings f1 and f2; the rest is the core f0.
inline constexpr double kEyeGlare = 0.478 + 0.138;
/// The core is exp(-x^2): a Gaussian of this variance.
inline constexpr double kEyeCoreVariance = 0.5;

/// The published function, per steradian, theta in degrees (0 to 90). Its integral over the half space is 1
/// within 3 %.
double eye_published(double p_theta_deg);
/// The wings alone, (0.478 f1 + 0.138 f2)/0.616 on a flat sky, f1 and f2 each normalised to 1 within 90
/// degrees (x = 4500; f1 to infinity); published they are so within 0.1 % and 3 %.
double eye_wings_profile(double p_x);
double eye_wings_encircled(double p_x);

} // namespace blackhole
