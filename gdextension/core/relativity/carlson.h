// SPDX-License-Identifier: MIT
#pragma once

#include "core/relativity/dual.h"

#include <cmath>

namespace blackhole {

/// Carlson's symmetric integral R_F(x, y, z) where y and z enter only through
///   product = sqrt(y z) and sum = (sqrt y + sqrt z)^2,
/// so that they may be two real numbers or a conjugate pair, and nothing happens where one case becomes the
/// other (orbits at the critical impact parameter). Carlson's duplication step in these variables is
///   r = sqrt(x sum), lambda = r + product, x' = (x + lambda)/4,
///   product' = sqrt(sum (x + lambda))/4, sum' = (sum + 2 r)/4 + 2 product',
/// in which every term is positive. Relative error below 1e-15. B. C. Carlson, Numer. Algorithms 10
/// (1995) 13.
template <class Real>
Real carlson_rf_pair(Real x, Real sum, Real product) {
	using std::sqrt;
	Real mean = (x + sum - 2.0 * product) / 3.0;
	for (int step = 0; step < 60; ++step) {
		const double m = value_of(mean);
		const double p = value_of(product) / m;
		const double spread_x = std::abs(value_of(x) / m - 1.0);
		const double spread_pair = std::abs(1.0 - value_of(sum) / m + 2.0 * p + p * p);
		if (spread_x < 8e-3 && spread_pair < 6e-5) {
			break; // the first neglected term is of the eighth order in these deviations
		}
		const Real r = sqrt(x * sum);
		const Real shifted = x + r + product;
		const Real next_product = 0.25 * sqrt(sum * shifted);
		sum = 0.25 * (sum + 2.0 * r) + 2.0 * next_product;
		x = 0.25 * shifted;
		product = next_product;
		mean = (x + sum - 2.0 * product) / 3.0;
	}
	// Carlson's expansion about the mean, from the elementary symmetric functions of the three deviations.
	const Real dx = 1.0 - x / mean;
	const Real pair = 1.0 - (sum - 2.0 * product) / mean + (product / mean) * (product / mean);
	const Real e2 = pair - dx * dx;
	const Real e3 = dx * pair;
	const Real series = 1.0 - e2 / 10.0 + e3 / 14.0 + e2 * e2 / 24.0 - (3.0 / 44.0) * e2 * e3 -
			(5.0 / 208.0) * e2 * e2 * e2 + (3.0 / 104.0) * e3 * e3 + (1.0 / 16.0) * e2 * e2 * e3;
	return series / sqrt(mean);
}

} // namespace blackhole
