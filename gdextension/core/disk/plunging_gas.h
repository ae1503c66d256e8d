// SPDX-License-Identifier: MIT
#pragma once

namespace blackhole {

/// Gas that has left the last stable circular orbit (r = 3 r_s) and plunges with that orbit's energy
/// sqrt(8/9) and angular momentum sqrt(3) r_s c, in the disk's plane.

/// Light as it leaves the gas.
struct EmittedLight {
	double a = 0.0; ///< inverse impact parameter [1/r_s]
	/// sin(azimuth) sin(inclination) of the line of sight (core/disk/disk_crossing.h): the share of the
	/// light's angular momentum that lies along -N.
	double tilt = 0.0;
	bool outgoing = false; ///< on its way out; else on its way in
};

/// nu_infinity/nu_emitted of light from gas at r [r_s], 0 < r <= 3, that turns right-handedly about N: the
/// scalar product of the four-velocity and the light's four-momentum (Misner, Thorne and Wheeler, chapter
/// 25). Light on its way out exists for r > 1 only; NaN otherwise. Relative error about 1e-15, through the
/// horizon.
double plunging_redshift(double r, const EmittedLight &light);

} // namespace blackhole
