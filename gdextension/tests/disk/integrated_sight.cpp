// SPDX-License-Identifier: MIT
#include "disk/integrated_sight.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace blackhole::test {
namespace {

/// dT/dphi of light on its way to the eye, of the null condition -dT^2 + (dr + sqrt(u) dT)^2 + r^2 dphi^2 =
/// 0, from u and du/dphi as followed backwards.
double time_rate(double u, double backward_slope) {
	const double r_rate = backward_slope / (u * u); // dr/dphi forwards in time
	const double length2 = r_rate * r_rate + 1.0 / (u * u);
	const double drag = std::sqrt(u) * r_rate;
	return length2 / (std::sqrt(drag * drag + (1.0 - u) * length2) - drag);
}

} // namespace

IntegratedSight::IntegratedSight(double u, double slope) : deepest(std::max(1.0, u)), orbit(u, slope) {}

double IntegratedSight::radius_at(double chi) {
	while (at < chi && !ended) {
		// Far out the radius changes much within a small angle.
		const double far_step = std::max(0.05 * std::abs(orbit.u() / orbit.slope()), 2e-4);
		const double natural = std::min(orbit.natural_step(), far_step);
		const double step = std::min(natural, chi - at);
		// Simpson's rule, with the middle that the orbit comes through.
		std::array<double, 3> rates{time_rate(orbit.u(), orbit.slope())};
		for (int half = 1; half <= 2; ++half) {
			orbit.advance(0.5 * step);
			rates[half] = time_rate(orbit.u(), orbit.slope());
		}
		time += step / 6.0 * (rates[0] + 4.0 * rates[1] + rates[2]);
		at = step == natural ? at + step : chi;
		ended = !(orbit.u() > 0.0 && orbit.u() < deepest);
	}
	return ended ? std::numeric_limits<double>::quiet_NaN() : 1.0 / orbit.u();
}

double IntegratedSight::margin() const {
	return std::min(std::abs(orbit.u()), std::abs(deepest - orbit.u()));
}

double first_meeting_angle(double inclination, double azimuth) {
	// The plane is met where the way, turned by chi from the observer, is square to N.
	const glm::dvec3 normal(std::sin(inclination), 0.0, std::cos(inclination));
	const glm::dvec3 across(std::cos(azimuth), std::sin(azimuth), 0.0);
	const double chi = std::atan2(-normal.z, glm::dot(across, normal));
	return chi < 0.0 ? chi + std::numbers::pi : chi;
}

} // namespace blackhole::test
