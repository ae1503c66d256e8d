// SPDX-License-Identifier: MIT
#include "core/disk/page_thorne.h"

#include "core/relativity/critical.h"
#include "core/relativity/physical_scale.h"

#include <cmath>
#include <numbers>

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

double hottest_ring_temperature(double mass_solar, double accretion_rate) {
	constexpr double kStefanBoltzmann = 5.670374419e-8; // W/(m^2 K^4)
	constexpr double kGravitation = 6.6743e-11;         // m^3/(kg s^2), CODATA 2018
	constexpr double kYear = 3.15576e7;                 // s, Julian
	const double c = kSpeedOfLight;
	const double gravitational_radius = kSolarMassParameter * mass_solar / (c * c);  // G M/c^2
	const double rate = kSolarMassParameter / kGravitation * accretion_rate / kYear; // kg/s
	const double flux = 3.0 * rate * c * c /
			(8.0 * std::numbers::pi * gravitational_radius * gravitational_radius) *
			page_thorne_flux(kHottestRing);
	return std::pow(flux / kStefanBoltzmann, 0.25);
}

} // namespace blackhole
