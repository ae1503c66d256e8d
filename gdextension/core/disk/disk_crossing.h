// SPDX-License-Identifier: MIT
#pragma once

namespace blackhole {

/// A line of sight and a plane through the hole, the disk's.
struct DiskSight {
	double u = 0.0;           ///< r_s/r of the observer
	double y = 0.0;           ///< sigma - sigma_c of the viewing direction; <= 0: the hole's
	double inclination = 0.0; ///< rad, between the observer's place and the disk's normal N
	/// rad, of the viewing direction about the inward axis: 0 towards N, +pi/2 to the right (right x up =
	/// outward).
	double azimuth = 0.0;
};

/// Where the line of sight, followed backwards, meets the plane.
struct DiskCrossing {
	/// r [r_s], also within the horizon for an observer there; NaN where the line of sight does not come so
	/// far, and for the few of which neither end is at infinity: the hole's, from below the photon sphere.
	double radius;
	double chi;    ///< rad, orbital angle between the observer and the place
	bool outgoing; ///< the light left it on its way out: between the hole and an eye that looks inwards
};

/// The (order + 1)-th meeting (order 0, 1, 2, ...). From the exact angles; relative error of the radius about
/// 1e-13 (to 1e-11 where the line of sight grazes the plane at a great radius).
DiskCrossing disk_crossing(const DiskSight &sight, int order);

/// nu_observed/nu_emitted over nu_observed/nu_infinity, for gas on the circular orbit of radius r > 1.5 r_s,
/// right-handed about N, and light with inverse impact parameter a [1/r_s]; NaN for r < 1.5, where no orbit
/// is. (Luminet, A&A 75 (1979) 228.)
double disk_redshift(double r, double a, double inclination, double azimuth);

} // namespace blackhole
