// SPDX-License-Identifier: MIT
#include "core/disk/page_thorne.h"

#include "core/relativity/critical.h"

#include <cmath>

#include <boost/math/quadrature/gauss.hpp>

namespace blackhole {
namespace {

const double kSqrt6 = std::sqrt(6.0);

/// The bracket of the flux: the integral of (x^2 - 6)/(x^2 - 3) from sqrt 6 to x = sqrt 6 + beyond.
double bracket(double beyond) {
	if (beyond < 0.5) {
		// Its terms cancel here; the integrand is smooth and positive.
		return boost::math::quadrature::gauss<double, 15>::integrate(
				[](double t) {
					const double numerator = t * (t + 2.0 * kSqrt6);
					return numerator / (numerator + 3.0);
				},
				0.0, beyond);
	}
	return beyond +
			0.5 * kSqrt3 * (std::log1p(beyond / (kSqrt6 + kSqrt3)) - std::log1p(beyond / (kSqrt6 - kSqrt3)));
}

} // namespace

double page_thorne_flux(double r) {
	if (r < kInnermostStable) {
		return 0.0;
	}
	const double x = std::sqrt(2.0 * r);
	const double x2 = 2.0 * r;
	return bracket(2.0 * (r - kInnermostStable) / (x + kSqrt6)) / (x2 * x2 * x * (x2 - 3.0));
}

double page_thorne_temperature(double r) {
	static const double kLargest = page_thorne_flux(kHottestRing);
	return std::pow(page_thorne_flux(r) / kLargest, 0.25);
}

} // namespace blackhole
