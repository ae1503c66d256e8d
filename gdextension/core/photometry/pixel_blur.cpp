// SPDX-License-Identifier: MIT
#include "core/photometry/pixel_blur.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/special_functions/bessel.hpp>

namespace blackhole {

namespace {

constexpr double kWindow = 6.5; // standard deviations: beyond, a Gaussian is below 1e-9

/// exp(-z) I0(z) and exp(-z) I1(z).
std::pair<double, double> scaled_bessel_i(double p_z) {
	if (p_z > 60.0) { // asymptotic series, to 1e-8
		const double e = 1.0 / (8.0 * p_z);
		const double root = 1.0 / std::sqrt(2.0 * std::numbers::pi * p_z);
		return {root * (1.0 + e * (1.0 + e * (4.5 + e * 37.5))),
				root * (1.0 - e * (3.0 + e * (7.5 + e * 52.5)))};
	}
	using Policy = boost::math::policies::policy<boost::math::policies::promote_double<false>>;
	const double scale = std::exp(-p_z);
	return {scale * boost::math::cyl_bessel_i(0, p_z, Policy()),
			scale * boost::math::cyl_bessel_i(1, p_z, Policy())};
}

} // namespace

double pixel_blurred(const std::function<double(double)> &p_encircled, double p_sigma, double p_r) {
	// Light on a thin ring of radius a adds k(a) = exp(-(r^2 + a^2)/2) I0(r a)/(2 pi) at r (in units of
	// sigma). By parts, the sum over rings is the integral of -k'(a) times the encircled light, which is
	// smooth where the pattern is not. The light within r is taken out, as what remains is small in the
	// wings.
	const double r = p_r / p_sigma;
	const double within = p_encircled(p_r);
	const auto integrand = [&](double a) {
		const auto [i0, i1] = scaled_bessel_i(r * a);
		const double slope = std::exp(-0.5 * (r - a) * (r - a)) * (a * i0 - r * i1);
		return (p_encircled(a * p_sigma) - within) * slope;
	};
	double sum = within * std::exp(-0.5 * r * r);
	double from = std::max(0.0, r - kWindow);
	// Finer near the middle, where narrow patterns have their light.
	double step = from > 0.0 ? 1.0 : 1.0 / 16.0;
	while (from < r + kWindow) {
		sum += boost::math::quadrature::gauss<double, 7>::integrate(integrand, from, from + step);
		from += step;
		step = std::min(1.0, 2.0 * step);
	}
	return sum / (2.0 * std::numbers::pi * p_sigma * p_sigma);
}

} // namespace blackhole
