// SPDX-License-Identifier: MIT
#include "core/relativity/view_angle.h"

#include "core/relativity/critical.h"

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <cmath>

namespace blackhole {
namespace {

using Quad = boost::multiprecision::cpp_bin_float_quad;

/// kappa tan(xi/2) - sigma_c(u) with 33 digits, of which the double result keeps the leading ones.
double sigma_offset(const Quad &u, const Quad &kappa, const Quad &xi) {
	const Quad critical_a = 2 / (3 * sqrt(Quad(3)));
	const Quad slope = (u - Quad(2) / 3) * sqrt(u + Quad(1) / 3);
	const Quad edge = slope < 0 ? Quad(u * (1 - u) / (critical_a - slope)) : Quad((critical_a + slope) / u);
	return static_cast<double>(kappa * tan(xi / 2) - edge);
}

} // namespace

double view_angle(double u, double y, double kappa) {
	return 2.0 * std::atan2(critical_sigma(u) + y, kappa);
}

double view_angle_beyond_shadow(double u, double y, double kappa) {
	// tan of the difference of the two half angles
	const double edge = critical_sigma(u);
	return 2.0 * std::atan2(kappa * y, kappa * kappa + edge * (edge + y));
}

double view_angle_slope(double u, double y, double kappa) {
	const double size = std::hypot(critical_sigma(u) + y, kappa);
	return 2.0 * (kappa / size) / size;
}

double static_sigma_offset(double u, double xi) {
	return sigma_offset(u, sqrt(1 - Quad(u)), xi);
}

double rain_sigma_offset(double u, double xi) {
	return sigma_offset(u, 1 + sqrt(Quad(u)), xi);
}

} // namespace blackhole
