// SPDX-License-Identifier: MIT
#include "src/exact_results.h"

#include <string>

#include <godot_cpp/variant/utility_functions.hpp>

#include "core/relativity/shadow.h"
#include "core/relativity/star_image.h"
#include "src/glm_adapter.h"

using namespace godot;

namespace {

void complain(const char *caller, const char *method, const std::string &reason) {
	UtilityFunctions::push_error(String(caller) + "." + method + ": " + String::utf8(reason.c_str()));
}

} // namespace

blackhole::ObserverMotion core_motion(LensingTable::Motion motion) {
	switch (motion) {
		case LensingTable::MOTION_RAIN:
			return blackhole::ObserverMotion::kRain;
		case LensingTable::MOTION_INFALL:
			return blackhole::ObserverMotion::kInfall;
		case LensingTable::MOTION_ORBIT:
			return blackhole::ObserverMotion::kOrbit;
		case LensingTable::MOTION_VELOCITY:
			return blackhole::ObserverMotion::kVelocity;
		default:
			return blackhole::ObserverMotion::kStatic;
	}
}

Dictionary exact_star_image(const char *caller, const Vector3 &position, const Vector3 &star, int order,
		const blackhole::ObserverField &observer) {
	const blackhole::Outcome<blackhole::StarImage> image =
			blackhole::star_image(to_glm(position), to_glm(star), order, observer);
	Dictionary result;
	if (!image) {
		complain(caller, "star_image", image.error);
		return result;
	}
	result["direction"] = to_godot(image.value->direction);
	result["xi"] = image.value->xi;
	result["orbital_angle"] = image.value->orbital_angle;
	result["magnification"] = image.value->magnification;
	result["redshift"] = image.value->redshift;
	return result;
}

Dictionary exact_trace(const char *caller, const Vector3 &position, const Vector3 &view_direction,
		const blackhole::ObserverField &observer) {
	const blackhole::Outcome<blackhole::SkyRay> ray =
			blackhole::trace_view_direction(to_glm(position), to_glm(view_direction), observer);
	Dictionary result;
	if (!ray) {
		complain(caller, "trace", ray.error);
		return result;
	}
	result["captured"] = ray.value->captured;
	result["sky_direction"] = to_godot(ray.value->sky_direction);
	result["redshift"] = ray.value->redshift;
	return result;
}

Dictionary exact_disk_point(const char *caller, const Vector3 &position, const Vector3 &view_direction,
		const blackhole::DiskPlane &plane, int order, const blackhole::ObserverField &observer) {
	const blackhole::Outcome<blackhole::DiskPoint> point =
			blackhole::seen_disk_point(to_glm(position), to_glm(view_direction), plane, order, observer);
	Dictionary result;
	if (!point) {
		complain(caller, "disk_point", point.error);
		return result;
	}
	result["reached"] = point.value->reached;
	result["radius"] = point.value->radius;
	result["place"] = to_godot(point.value->place);
	result["redshift"] = point.value->redshift;
	return result;
}

Dictionary exact_plane_crossing(const char *caller, const Vector3 &position, const Vector3 &view_direction,
		const Vector3 &normal, int order, const blackhole::ObserverField &observer) {
	const blackhole::Outcome<blackhole::PlaneCrossing> crossing = blackhole::plane_crossing(
			to_glm(position), to_glm(view_direction), to_glm(normal), order, observer);
	Dictionary result;
	if (!crossing) {
		complain(caller, "plane_crossing", crossing.error);
		return result;
	}
	if (crossing.value->reached) {
		result["radius"] = crossing.value->radius;
		result["position"] = to_godot(crossing.value->position);
	}
	return result;
}
