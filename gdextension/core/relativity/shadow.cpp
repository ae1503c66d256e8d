// SPDX-License-Identifier: MIT
#include "core/relativity/shadow.h"

#include "core/relativity/critical.h"
#include "core/relativity/orbital_angle.h"
#include "core/relativity/redshift.h"
#include "core/relativity/sky_frame.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace blackhole {

double shadow_half_angle(double u, ObserverMotion motion) {
	return 2.0 * std::atan2(critical_sigma(u), radial_kappa(u, motion));
}

Outcome<SkyRay> trace_view_direction(
		glm::dvec3 position_rs, glm::dvec3 view_direction, ObserverMotion motion) {
	const Outcome<SkyFrame> frame = sky_frame(position_rs, view_direction, motion);
	if (!frame) {
		return Outcome<SkyRay>::failure(frame.error);
	}
	const SkyFrame &at = *frame.value;
	SkyRay ray;
	// xi is the direction's angle from the inward radial: its complement is at.angle.
	const double sigma = at.kappa * (at.far / at.near);
	const double y = sigma - critical_sigma(at.u);
	ray.captured = !(y > 0.0);
	if (ray.captured) {
		return Outcome<SkyRay>::success(ray);
	}
	if (at.near < 1e-100) {
		ray.sky_direction = at.outward; // straight away from the hole
		ray.redshift = 1.0 / at.kappa;  // the limit sigma -> infinity of radial_redshift()
		return Outcome<SkyRay>::success(ray);
	}
	ray.orbital_angle = orbital_angle(at.u, y);
	ray.sky_direction = at.outward * std::cos(ray.orbital_angle) + at.azimuth * std::sin(ray.orbital_angle);
	ray.redshift = radial_redshift(at.u, y, at.kappa);
	return Outcome<SkyRay>::success(ray);
}

} // namespace blackhole
