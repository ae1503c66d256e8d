// SPDX-License-Identifier: MIT
#include "core/relativity/shadow.h"

#include "core/relativity/critical.h"
#include "core/relativity/orbital_angle.h"
#include "core/relativity/redshift.h"
#include "core/relativity/sky_frame.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

namespace blackhole {

double shadow_half_angle(double u, ObserverMotion motion) {
	return 2.0 * std::atan2(critical_sigma(u), radial_kappa(u, motion));
}

Outcome<ApparentShadow> apparent_shadow(glm::dvec3 position_rs, const ObserverField &observer) {
	const Outcome<LocalObserver> local = local_observer(observer, position_rs);
	if (!local) {
		return Outcome<ApparentShadow>::failure(local.error);
	}
	const LocalObserver &at = *local.value;
	ApparentShadow shadow;
	shadow.centre = -at.outward;
	shadow.half_angle = 2.0 * std::atan2(critical_sigma(at.u), at.kappa);
	const glm::dvec3 sideways = at.celerity - at.outward * glm::dot(at.celerity, at.outward);
	if (at.celerity == glm::dvec3(0.0)) {
		return Outcome<ApparentShadow>::success(shadow);
	}
	// The two points of the edge in the plane of axis and motion lie opposite each other after the boost as
	// well.
	const glm::dvec3 helper =
			std::abs(at.outward.x) < 0.6 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
	// A motion along the axis has no side but rounding's.
	const bool aside = glm::length(sideways) > 1e-9 * glm::length(at.celerity);
	const glm::dvec3 side = glm::normalize(aside ? sideways : glm::cross(at.outward, helper));
	const glm::dvec3 along = shadow.centre * std::cos(shadow.half_angle);
	const glm::dvec3 across = side * std::sin(shadow.half_angle);
	const glm::dvec3 first = boost_direction(along + across, at.celerity);
	const glm::dvec3 second = boost_direction(along - across, at.celerity);
	const glm::dvec3 inside = boost_direction(shadow.centre, at.celerity);
	const double between = std::atan2(glm::length(first - second), glm::length(first + second));
	shadow.centre = glm::length(first + second) > 1e-12 ? glm::normalize(first + second) : inside;
	shadow.half_angle = between;
	if (glm::dot(shadow.centre, inside) < std::cos(between)) {
		shadow.centre = -shadow.centre;
		shadow.half_angle = std::numbers::pi - between;
	}
	return Outcome<ApparentShadow>::success(shadow);
}

Outcome<SkyRay> trace_view_direction(
		glm::dvec3 position_rs, glm::dvec3 view_direction, const ObserverField &observer) {
	const Outcome<ViewFrame> frame = view_frame(position_rs, view_direction, observer);
	if (!frame) {
		return Outcome<SkyRay>::failure(frame.error);
	}
	const SkyFrame &at = frame.value->at;
	const double doppler = frame.value->doppler;
	SkyRay ray;
	// xi is the direction's angle from the inward radial: its complement is at.angle.
	const double sigma = at.kappa * (at.far / at.near);
	const double y = sigma - critical_sigma(at.u);
	ray.captured = !(y > 0.0);
	if (ray.captured) {
		return Outcome<SkyRay>::success(ray);
	}
	if (at.near < 1e-100) {
		ray.sky_direction = at.outward;    // straight away from the hole
		ray.redshift = doppler / at.kappa; // the limit sigma -> infinity of radial_redshift()
		return Outcome<SkyRay>::success(ray);
	}
	ray.orbital_angle = orbital_angle(at.u, y);
	ray.sky_direction = at.outward * std::cos(ray.orbital_angle) + at.azimuth * std::sin(ray.orbital_angle);
	ray.redshift = doppler * radial_redshift(at.u, y, at.kappa);
	return Outcome<SkyRay>::success(ray);
}

} // namespace blackhole
