// SPDX-License-Identifier: MIT
#include "core/disk/disk_crossing.h"

#include "core/disk/ray_radius.h"
#include "core/relativity/critical.h"
#include "core/relativity/light_ray.h"
#include "core/relativity/not_a_number.h"
#include "core/relativity/orbital_angle.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace blackhole {
namespace {

/// Orbital angle [rad] between the observer and the first crossing, 0 to pi.
double first_angle(const DiskSight &sight) {
	const double angle =
			std::atan2(std::cos(sight.inclination), -std::cos(sight.azimuth) * std::sin(sight.inclination));
	return angle < 0.0 ? angle + std::numbers::pi : angle;
}

} // namespace

DiskCrossing disk_crossing(const DiskSight &sight, int order) {
	const LightRay<double> ray(sight.u, sight.y);
	const double chi = first_angle(sight) + std::numbers::pi * order;
	const double ahead = sight.y > 0.0 ? orbital_angle(sight.u, sight.y) - chi : kNaN; // from the sky's end
	double behind = kNaN;
	if (ray.u_slope < 0.0) {
		// The same ray followed the other way, past the observer, comes from infinity as well.
		const double other = (1.0 - sight.u) / ray.sigma - critical_sigma(sight.u);
		behind = other > 0.0 ? orbital_angle(sight.u, other) + chi : kNaN;
	}
	const bool outgoing = behind < ahead || std::isnan(ahead);
	const double eta = outgoing ? behind : ahead;
	// Followed backwards, light that is seen comes from nowhere deeper than its observer and the horizon.
	const double u = inverse_radius_on_ray(ray.a, ray.epsilon, eta, std::max(1.0, sight.u));
	return {1.0 / u, chi, outgoing};
}

double disk_redshift(double r, double a, double inclination, double azimuth) {
	if (!(r > 1.5)) {
		return kNaN;
	}
	const double orbit = std::sqrt(0.5 / (r * r * r));
	return std::sqrt(1.0 - 1.5 / r) / (1.0 + orbit / a * std::sin(azimuth) * std::sin(inclination));
}

} // namespace blackhole
