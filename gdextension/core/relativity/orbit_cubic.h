// SPDX-License-Identifier: MIT
#pragma once

#include "core/relativity/critical.h"

#include <algorithm>
#include <cmath>

namespace blackhole {

/// What the angle integrals need of P(u) = u^3 - u^2 + a^2 = (du/dphi)^2: its negative root -w (always there)
/// and the other two roots through smooth functions of them alone (real for a < a_c, conjugate for a > a_c).
template <class Real>
struct OrbitCubic {
	/// w > 0: P(-w) = 0.
	Real w;
	/// (u_3 - u_2)^2: > 0 for real roots (turning point at u_2 <= 2/3), < 0 for a conjugate pair.
	Real gap_squared;
	/// u_2 + u_3 - 4/3 and (u_2 - 2/3)(u_3 - 2/3), both proportional to epsilon.
	Real offset_sum;
	Real offset_product;

	/// a > 0 is the inverse impact parameter, epsilon = a_c^2 - a^2 given to full relative precision.
	OrbitCubic(const Real &a, const Real &epsilon) : w(negative_root(a)) {
		// v = u - 2/3 turns P into v^2 (v + 1) - epsilon; v_1 = -w - 2/3 is its root near -1.
		const Real v1 = -w - kPhotonSphereU;
		offset_product = epsilon / v1;
		offset_sum = -offset_product / v1;
		gap_squared = offset_sum * offset_sum - 4.0 * offset_product;
	}

	/// The turning point u_2 (only for gap_squared >= 0).
	Real turning_point(const Real &a) const {
		using std::sqrt;
		const Real u3 = 0.5 * (1.0 + w + sqrt(gap_squared));
		return a * a / (w * u3);
	}

private:
	/// w^2 (1 + w) = a^2 by Newton's method from above (the function is convex), slopes by the implicit
	/// function.
	static double negative_root(double a) {
		const double a2 = a * a;
		double w = a < 1.0 ? a / std::sqrt(1.0 + 0.75 * a) : std::cbrt(a2);
		for (int step = 0; step < 40; ++step) {
			const double change = (w * w * (1.0 + w) - a2) / (w * (2.0 + 3.0 * w));
			w -= change;
			if (std::abs(change) <= 1e-9 * w) { // quadratic: the next change is below rounding
				break;
			}
		}
		return w - (w * w * (1.0 + w) - a2) / (w * (2.0 + 3.0 * w));
	}
	template <std::size_t N>
	static Dual<N> negative_root(const Dual<N> &a) {
		const double w = negative_root(a.value);
		return chain(a, w, 2.0 * a.value / (w * (2.0 + 3.0 * w)));
	}
};

} // namespace blackhole
