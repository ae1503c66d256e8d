// SPDX-License-Identifier: MIT
#pragma once

namespace blackhole {

/// A light ray from infinity to infinity with impact parameter b [r_s].
struct Deflection {
	/// b/b_c - 1, exact in b.
	double beyond_critical = 0.0;
	/// Exact deflection [rad]; NaN for b <= b_c (captured).
	double alpha = 0.0;
	/// Weak-field series 2/b + 15pi/16b^2 + 16/3b^3 + 3465pi/1024b^4.
	double alpha_weak = 0.0;
	/// Strong limit -ln(b/b_c - 1) + ln(216(7 - 4 sqrt 3)) - pi (Darwin 1959); NaN for b <= b_c.
	double alpha_strong = 0.0;
	/// Closest approach [r_s]; NaN for b <= b_c.
	double r_min = 0.0;
};

/// Relative error of alpha below 1e-14 for every b > b_c, also where alpha is tiny.
Deflection deflection(double b);

} // namespace blackhole
