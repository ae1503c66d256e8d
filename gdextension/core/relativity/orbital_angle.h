// SPDX-License-Identifier: MIT
#pragma once

namespace blackhole {

/// The total orbital angle with its exact slopes.
struct OrbitalAngle {
	/// Phi [rad].
	double phi = 0.0;
	/// dPhi/dy at fixed u (always < 0).
	double slope_y = 0.0;
	/// dPhi/du at fixed y.
	double slope_u = 0.0;
};

/// Total orbital angle Phi [rad] swept between the observer at u = r_s/r > 0 and infinity by the light ray
/// with sigma = sigma_c(u) + y, y > 0. Valid outside and inside the horizon, for y from 1e-300 to 1e150.
/// Relative error about 1e-15 (worst seen against 50-digit values: see tests). NaN for u <= 0 or y <= 0.
/// Carlson's R_F with the two-point formula (Carlson, Math. Comp. 49 (1987) 595).
double orbital_angle(double u, double y);

/// The same, and dPhi/dy.
OrbitalAngle orbital_angle_slope(double u, double y);

/// The same, and both slopes.
OrbitalAngle orbital_angle_slopes(double u, double y);

/// Angle [rad] from infinity to the turning point of a ray with impact parameter 1/a, given a < a_c and
/// epsilon = a_c^2 - a^2 > 0; half the total angle of a ray from infinity to infinity.
double angle_to_turning_point(double a, double epsilon);

} // namespace blackhole
