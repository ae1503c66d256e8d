// SPDX-License-Identifier: MIT
#include "core/relativity/deflection.h"

#include "core/relativity/critical.h"
#include "core/relativity/not_a_number.h"
#include "core/relativity/orbit_cubic.h"
#include "core/relativity/orbital_angle.h"

#include <cmath>
#include <numbers>

namespace blackhole {
namespace {

using std::numbers::pi;

/// alpha = sum over n >= 1 of sqrt(pi) Gamma((3n+1)/2) / (Gamma(n/2+1) n!) b^-n, convergent for b > b_c: used
/// where the exact total angle less pi would cancel. Two interleaved chains with rational ratios of terms.
double deflection_series(double b) {
	const double q = 1.0 / b;
	double odd = 2.0 * q;
	double even = 15.0 * pi / 16.0 * q * q;
	double sum = 0.0;
	for (int n = 1; n < 200; n += 2) {
		const double before = sum;
		sum += odd + even;
		if (sum == before) {
			break;
		}
		// term(n+2)/term(n): Gamma(x+3)/Gamma(x) with x = (3n+1)/2, over (n/2+1)(n+1)(n+2), times b^-2
		const auto ratio = [q](double m) {
			const double x = 0.5 * (3.0 * m + 1.0);
			return x * (x + 1.0) * (x + 2.0) / ((0.5 * m + 1.0) * (m + 1.0) * (m + 2.0)) * q * q;
		};
		odd *= ratio(n);
		even *= ratio(n + 1);
	}
	return sum;
}

} // namespace

Deflection deflection(double b) {
	Deflection result{kNaN, kNaN, kNaN, kNaN, kNaN};
	if (!(b > 0.0 && std::isfinite(b))) {
		return result;
	}
	const double excess = (b - kCriticalB) - kCriticalBRest;
	const double q = 1.0 / b;
	result.beyond_critical = excess / kCriticalB;
	result.alpha_weak = q * (2.0 + q * (15.0 * pi / 16.0 + q * (16.0 / 3.0 + q * (3465.0 * pi / 1024.0))));
	if (excess <= 0.0) {
		return result;
	}
	const double epsilon = kCriticalA * (excess / b) * (kCriticalA + q); // a_c^2 - a^2
	result.alpha_strong = -std::log(result.beyond_critical) + std::log(216.0 / (7.0 + 4.0 * kSqrt3)) - pi;
	result.alpha = b > 10.0 ? deflection_series(b) : 2.0 * angle_to_turning_point(q, epsilon) - pi;
	result.r_min = 1.0 / OrbitCubic<double>(q, epsilon).turning_point(q);
	return result;
}

} // namespace blackhole
