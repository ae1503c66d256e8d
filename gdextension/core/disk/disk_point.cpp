// SPDX-License-Identifier: MIT
#include "core/disk/disk_point.h"

#include "core/disk/disk_crossing.h"
#include "core/disk/page_thorne.h"
#include "core/disk/plunging_gas.h"
#include "core/relativity/critical.h"
#include "core/relativity/light_ray.h"
#include "core/relativity/redshift.h"
#include "core/relativity/sky_frame.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

namespace blackhole {
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
	const Outcome<ViewFrame> frame = view_frame(position_rs, view_direction, observer);
	if (!frame) {
		return Outcome<DiskPoint>::failure(frame.error);
	}
	const SkyFrame &at = frame.value->at;
	const glm::dvec3 normal = plane.normal / length;
	const double above = glm::dot(normal, at.outward);
	const double beside = glm::dot(normal, at.azimuth);
	const double aside = glm::dot(glm::cross(at.outward, at.azimuth), normal);
	const double y = at.kappa * (at.far / at.near) - critical_sigma(at.u);
	const DiskSight sight{at.u, y, std::atan2(std::hypot(beside, aside), above), std::atan2(aside, beside)};
	const DiskCrossing crossing = disk_crossing(sight, order);
	DiskPoint point;
	point.radius = crossing.radius;
	point.reached = !std::isnan(point.radius);
	if (!point.reached) {
		return Outcome<DiskPoint>::success(point);
	}
	point.place = at.outward * std::cos(crossing.chi) + at.azimuth * std::sin(crossing.chi);
	const double a = LightRay<double>(at.u, y).a;
	const double sense = plane.retrograde ? -1.0 : 1.0;
	const double emitted = point.radius >= kInnermostStable
			? disk_redshift(point.radius, a, 0.5 * std::numbers::pi, std::asin(sense * aside))
			: plunging_redshift(point.radius, {a, sense * aside, crossing.outgoing});
	point.redshift = radial_redshift(at.u, y, at.kappa) * emitted * frame.value->doppler;
	return Outcome<DiskPoint>::success(point);
}

} // namespace blackhole
