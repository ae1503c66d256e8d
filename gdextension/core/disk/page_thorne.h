// SPDX-License-Identifier: MIT
#pragma once

namespace blackhole {

/// The thin disk of Page and Thorne (ApJ 191 (1974) 499) round a Schwarzschild hole: each ring radiates what
/// the gas loses on its way inward, nothing at the last stable orbit, as a black body.

/// Radius of the last stable circular orbit [r_s].
inline constexpr double kInnermostStable = 3.0;
/// Radius of the hottest ring [r_s].
inline constexpr double kHottestRing = 4.77546403897193;

/// Flux of one face in units of 3 Mdot c^2 / (8 pi M^2) with G = c = 1, at r >= 3 r_s, to a few units of the
/// last digit (also next to r = 3, where the textbook's form loses all); 0 within, NaN for NaN.
double page_thorne_flux(double r);

/// Temperature over that of the hottest ring: (F/F_max)^(1/4), 0 to 1.
double page_thorne_temperature(double r);

/// Temperature [K] of the hottest ring of a disk round a hole of this mass [solar masses], onto which this
/// much falls [solar masses a year].
double hottest_ring_temperature(double mass_solar, double accretion_rate);

} // namespace blackhole
