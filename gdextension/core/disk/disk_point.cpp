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
namespace {

constexpr int kMostOrders = 60;
/// Sine of the angle to a plane below which somebody or something is on it: above the rounding of single
/// precision, in which scripts give their vectors.
constexpr double kOnPlane = 1e-6;

/// A line of sight and a plane through the hole.
struct Sighting {
	ViewFrame frame;
	double above = 0.0;  ///< the plane's unit normal along the frame's outward direction,
	double beside = 0.0; ///< along its azimuth
	double aside = 0.0;  ///< and across both
	DiskSight sight;
};

Outcome<Sighting> sighting(glm::dvec3 position_rs, glm::dvec3 view_direction, glm::dvec3 normal, int order,
		const ObserverField &observer) {
	const double length = glm::length(normal);
	if (order < 0 || order > kMostOrders) {
		return Outcome<Sighting>::failure("the order must be between 0 and 60");
	}
	if (!(length > 0.0 && std::isfinite(length))) {
		return Outcome<Sighting>::failure("the plane's normal must be finite and not zero");
	}
	const Outcome<ViewFrame> frame = view_frame(position_rs, view_direction, observer);
	if (!frame) {
		return Outcome<Sighting>::failure(frame.error);
	}
	Sighting result;
	result.frame = *frame.value;
	const SkyFrame &at = result.frame.at;
	result.above = glm::dot(normal, at.outward) / length;
	result.beside = glm::dot(normal, at.azimuth) / length;
	result.aside = glm::dot(glm::cross(at.outward, at.azimuth), normal) / length;
	const double y = at.kappa * (at.far / at.near) - critical_sigma(at.u);
	result.sight = {at.u, y, std::atan2(std::hypot(result.beside, result.aside), result.above),
			std::atan2(result.aside, result.beside)};
	return Outcome<Sighting>::success(result);
}

/// Unit vector from the hole to what is seen `chi` radians from the observer.
glm::dvec3 place_at(const SkyFrame &at, double chi) {
	return at.outward * std::cos(chi) + at.azimuth * std::sin(chi);
}

} // namespace

Outcome<DiskPoint> seen_disk_point(glm::dvec3 position_rs, glm::dvec3 view_direction, const DiskPlane &plane,
		int order, const ObserverField &observer) {
	const Outcome<Sighting> found = sighting(position_rs, view_direction, plane.normal, order, observer);
	if (!found) {
		return Outcome<DiskPoint>::failure(found.error);
	}
	const DiskSight &sight = found.value->sight;
	const SkyFrame &at = found.value->frame.at;
	const DiskCrossing crossing = disk_crossing(sight, order);
	DiskPoint point;
	point.radius = crossing.radius;
	point.reached = !std::isnan(point.radius);
	if (!point.reached) {
		return Outcome<DiskPoint>::success(point);
	}
	point.place = place_at(at, crossing.chi);
	const double a = LightRay<double>(sight.u, sight.y).a;
	const double spin = (plane.retrograde ? -1.0 : 1.0) * found.value->aside;
	const double emitted = point.radius >= kInnermostStable
			? disk_redshift(point.radius, a, 0.5 * std::numbers::pi, std::asin(spin))
			: plunging_redshift(point.radius, {a, spin, crossing.outgoing});
	point.redshift = radial_redshift(sight.u, sight.y, at.kappa) * emitted * found.value->frame.doppler;
	return Outcome<DiskPoint>::success(point);
}

Outcome<PlaneCrossing> plane_crossing(glm::dvec3 position_rs, glm::dvec3 view_direction, glm::dvec3 normal,
		int order, const ObserverField &observer) {
	const Outcome<Sighting> found = sighting(position_rs, view_direction, normal, order, observer);
	if (!found) {
		return Outcome<PlaneCrossing>::failure(found.error);
	}
	DiskSight sight = found.value->sight;
	int meeting = order;
	if (std::abs(found.value->above) < kOnPlane) {
		if (std::abs(found.value->beside) < kOnPlane) {
			return Outcome<PlaneCrossing>::success({}); // all of the line of sight lies in the plane
		}
		// Half a turn from the observer, whose own place is none of the meetings.
		sight.inclination = 0.5 * std::numbers::pi;
		sight.azimuth = found.value->beside < 0.0 ? std::numbers::pi : 0.0;
		meeting += found.value->beside < 0.0 ? 1 : 0;
	}
	const DiskCrossing crossing = disk_crossing(sight, meeting);
	PlaneCrossing result;
	result.reached = std::isfinite(crossing.radius);
	if (result.reached) {
		result.radius = crossing.radius;
		result.position = place_at(found.value->frame.at, crossing.chi) * crossing.radius;
	}
	return Outcome<PlaneCrossing>::success(result);
}

} // namespace blackhole
