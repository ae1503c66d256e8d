// SPDX-License-Identifier: MIT
#include "core/disk/disk_point.h"

#include "core/disk/disk_crossing.h"
#include "core/disk/page_thorne.h"
#include "core/disk/plunging_gas.h"
#include "core/relativity/critical.h"
#include "core/relativity/light_ray.h"
#include "core/relativity/orbital_angle.h"
#include "core/relativity/redshift.h"
#include "core/relativity/sky_frame.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

namespace blackhole {
namespace {

/// Whether light that is seen left the place at r on its way out: between the hole and an eye that looks
/// inwards.
bool leaves_outward(const LightRay<double> &ray, double y, double chi) {
	if (!(ray.u_slope < 0.0)) {
		return false;
	}
	if (!(y > 0.0)) {
		return true;
	}
	const double other = (1.0 - ray.u) / ray.sigma - critical_sigma(ray.u);
	return orbital_angle(ray.u, other) + chi < orbital_angle(ray.u, y) - chi;
}

} // namespace

Outcome<DiskPoint> seen_disk_point(glm::dvec3 position_rs, glm::dvec3 view_direction, const DiskPlane &plane,
		int order, const ObserverField &observer) {
	constexpr int kMostOrders = 60;
	const double length = glm::length(plane.normal);
	if (order < 0 || order > kMostOrders) {
		return Outcome<DiskPoint>::failure("the order must be between 0 and 60");
	}
	if (!(length > 0.0 && std::isfinite(length))) {
		return Outcome<DiskPoint>::failure("the disk's normal must be finite and not zero");
	}
	const Outcome<LocalObserver> local = local_observer(observer, position_rs);
	if (!local) {
		return Outcome<DiskPoint>::failure(local.error);
	}
	// The direction in the radially moving frame: the boost undone.
	const glm::dvec3 celerity = local.value->celerity;
	const bool boosted = celerity != glm::dvec3(0.0);
	const glm::dvec3 direction =
			boosted ? boost_direction(glm::normalize(view_direction), -celerity) : view_direction;
	const Outcome<SkyFrame> frame = sky_frame(*local.value, direction);
	if (!frame) {
		return Outcome<DiskPoint>::failure(frame.error);
	}
	const SkyFrame &at = *frame.value;
	const glm::dvec3 normal = plane.normal / length;
	const double above = glm::dot(normal, at.outward);
	const double beside = glm::dot(normal, at.azimuth);
	const double aside = glm::dot(glm::cross(at.outward, at.azimuth), normal);
	const double y = at.kappa * (at.far / at.near) - critical_sigma(at.u);
	// Inclination and azimuth as disk_crossing_radius() has them.
	const DiskSight sight{at.u, y, std::atan2(std::hypot(beside, aside), above), std::atan2(aside, beside)};
	DiskPoint point;
	point.radius = disk_crossing_radius(sight, order);
	point.reached = !std::isnan(point.radius);
	if (!point.reached) {
		return Outcome<DiskPoint>::success(point);
	}
	double chi = std::atan2(above, -beside);
	chi += (chi < 0.0 ? order + 1 : order) * std::numbers::pi;
	point.place = at.outward * std::cos(chi) + at.azimuth * std::sin(chi);
	const LightRay<double> ray(at.u, y);
	const double sense = plane.retrograde ? -1.0 : 1.0;
	const double emitted = point.radius >= kInnermostStable
			? disk_redshift(point.radius, ray.a, 0.5 * std::numbers::pi, std::asin(sense * aside))
			: plunging_redshift(point.radius, {ray.a, sense * aside, leaves_outward(ray, y, chi)});
	const double observed = radial_redshift(at.u, y, at.kappa);
	point.redshift = observed * emitted * (boosted ? doppler_factor(direction, celerity) : 1.0);
	return Outcome<DiskPoint>::success(point);
}

} // namespace blackhole
