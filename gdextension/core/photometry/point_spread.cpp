// SPDX-License-Identifier: MIT
#include "core/photometry/point_spread.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <boost/math/special_functions/bessel.hpp>

namespace blackhole {

namespace {

using std::numbers::pi;

/// Share of f1 in the wings.
constexpr double kCubeLaw = 0.478 / kEyeGlare;
constexpr double kEdge = 4500.0; // 90 degrees

double bessel_j(int p_order, double p_x) {
	using Policy = boost::math::policies::policy<boost::math::policies::promote_double<false>>;
	return boost::math::cyl_bessel_j(p_order, p_x, Policy());
}

/// Integral of x/(1+x)^2.
double square_law_light(double p_x) {
	return std::log1p(p_x) - p_x / (1.0 + p_x);
}

} // namespace

double airy_profile(double p_x) {
	const double amplitude = p_x < 1e-6 ? 0.5 : bessel_j(1, p_x) / p_x;
	return amplitude * amplitude / pi;
}

double airy_encircled(double p_x) {
	const double j0 = bessel_j(0, p_x);
	const double j1 = bessel_j(1, p_x);
	return 1.0 - j0 * j0 - j1 * j1;
}

glm::dvec3 airy_angles(double p_aperture) {
	return kChannelWavelengths / (pi * p_aperture);
}

double eye_published(double p_theta_deg) {
	const double beyond = p_theta_deg + 0.02;
	const double f0 = 2.61e6 * std::exp(-p_theta_deg * p_theta_deg / (0.02 * 0.02));
	const double f1 = 20.91 / (beyond * beyond * beyond);
	const double f2 = 72.37 / (beyond * beyond);
	return 0.384 * f0 + 0.478 * f1 + 0.138 * f2;
}

double eye_wings_profile(double p_x) {
	const double cube = 1.0 / (pi * (1.0 + p_x) * (1.0 + p_x) * (1.0 + p_x));
	const double square =
			p_x < kEdge ? 1.0 / (2.0 * pi * square_law_light(kEdge) * (1.0 + p_x) * (1.0 + p_x)) : 0.0;
	return kCubeLaw * cube + (1.0 - kCubeLaw) * square;
}

double eye_wings_encircled(double p_x) {
	const double part = p_x / (1.0 + p_x);
	const double square = square_law_light(std::min(p_x, kEdge)) / square_law_light(kEdge);
	return kCubeLaw * part * part + (1.0 - kCubeLaw) * square;
}

} // namespace blackhole
