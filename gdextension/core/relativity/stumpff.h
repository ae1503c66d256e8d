// SPDX-License-Identifier: MIT
#pragma once

#include <boost/math/special_functions/sinc.hpp>
#include <boost/math/special_functions/sinhc.hpp>

#include <cmath>

namespace blackhole {

/// Stumpff's functions c_n(z) = sum (-z)^j/(n + 2j)!: with them one formula describes bound (z > 0),
/// parabolic (z = 0) and unbound (z < 0) motion, smoothly through zero (Battin, Astrodynamics, sec. 4.5). For
/// z <= pi^2, which is where radial motion stays. Relative error 1e-15 (c_0: absolute for z > 0).
struct Stumpff {
	/// cos(sqrt z).
	static double c0(double z) { return z > 0.0 ? std::cos(std::sqrt(z)) : std::cosh(std::sqrt(-z)); }

	/// sin(sqrt z)/sqrt z.
	static double c1(double z) {
		return z > 0.0 ? boost::math::sinc_pi(std::sqrt(z)) : boost::math::sinhc_pi(std::sqrt(-z));
	}

	/// (1 - cos(sqrt z))/z.
	static double c2(double z) {
		const double half = c1(0.25 * z);
		return 0.5 * half * half;
	}

	/// (sqrt z - sin(sqrt z))/sqrt(z)^3.
	static double c3(double z) {
		if (std::abs(z) > 1.0) {
			return (1.0 - c1(z)) / z;
		}
		// The series by Horner's rule; the first term left out is below 1e-17 of the sum.
		double sum = 1.0;
		for (int n = 18; n >= 4; n -= 2) {
			sum = 1.0 - z / (n * (n + 1.0)) * sum;
		}
		return sum / 6.0;
	}
};

} // namespace blackhole
