// SPDX-License-Identifier: MIT
#pragma once

namespace blackhole {

/// Direction of the light ray that sweeps a given orbital angle, in the frame-free variable sigma.
struct ImageDirection {
	/// y = sigma - sigma_c > 0, with its own relative precision (sigma = sigma_c + y loses it near the
	/// shadow).
	double y = 0.0;
	/// dy/dPhi = dsigma/dPhi at fixed u (< 0).
	double slope = 0.0;
};

/// The inverse of orbital_angle(): the y with Phi(u, y) = phi, for u > 0 and 0 < phi <= 300 rad, by Newton's
/// method on a nearly linear variable inside a bracket. Relative error of y about phi times 2e-16, or 1e-15
/// if larger. NaN for values out of range.
ImageDirection image_direction(double u, double phi);

} // namespace blackhole
