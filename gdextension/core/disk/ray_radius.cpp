// SPDX-License-Identifier: MIT
#include "core/disk/ray_radius.h"

#include "core/relativity/critical.h"
#include "core/relativity/not_a_number.h"
#include "core/relativity/orbit_cubic.h"
#include "core/relativity/orbital_angle.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <boost/math/tools/toms748_solve.hpp>

namespace blackhole {
namespace {

/// y = sigma - sigma_c of the ray at u on its way out, without the cancellations near the critical ray.
double outgoing_offset(double a, double epsilon, double u) {
	const double critical_slope = photon_sphere_offset(u) * critical_omega(u);
	const double slope = std::sqrt(std::max(critical_slope * critical_slope - epsilon, 0.0));
	if (u < kPhotonSphereU) {
		return (a + slope) / u - critical_sigma(u);
	}
	const double a_offset = -epsilon / (a + kCriticalA);
	return (a_offset - epsilon / (slope + critical_slope)) / u;
}

/// The angle from infinity to u.
double angle_to(double a, double epsilon, double u) {
	return orbital_angle(u, outgoing_offset(a, epsilon, u));
}

} // namespace

double inverse_radius_on_ray(double a, double epsilon, double eta, double deepest) {
	if (!(a > 0.0 && eta > 0.0)) {
		return kNaN;
	}
	const bool turns = epsilon > 0.0;
	const double highest = turns ? OrbitCubic<double>(a, epsilon).turning_point(a) : deepest;
	const double largest = turns ? angle_to_turning_point(a, epsilon) : angle_to(a, epsilon, deepest);
	if (!(eta < largest)) {
		return kNaN;
	}
	std::uintmax_t steps = 200;
	const auto bracket = boost::math::tools::toms748_solve(
			[a, epsilon, eta](double u) { return angle_to(a, epsilon, u) - eta; }, 0.0, highest, -eta,
			largest - eta, boost::math::tools::eps_tolerance<double>(50), steps);
	return 0.5 * (bracket.first + bracket.second);
}

} // namespace blackhole
