// SPDX-License-Identifier: MIT
#include "src/sky_observer.h"

#include <cmath>
#include <limits>

#include <godot_cpp/variant/utility_functions.hpp>

#include "core/relativity/shadow.h"
#include "core/relativity/star_image.h"
#include "src/exact_results.h"
#include "src/glm_adapter.h"

using namespace godot;

namespace {

constexpr double kLargestEnergy = 1e6;

} // namespace

blackhole::ObserverField SkyObserver::field() const {
	blackhole::ObserverField field(core_motion(motion));
	field.energy = energy;
	field.outgoing = outgoing;
	field.axis = to_glm(axis);
	field.celerity = to_glm(celerity);
	field.relative_to_static = relative_to_static;
	return field;
}

void SkyObserver::set_motion(LensingTable::Motion p_motion) {
	if (p_motion != motion && p_motion >= LensingTable::MOTION_STATIC &&
			p_motion <= LensingTable::MOTION_VELOCITY) {
		motion = p_motion;
		emit_changed();
	}
}

void SkyObserver::set_energy(double p_energy) {
	if (p_energy != energy && p_energy > 0.0 && p_energy <= kLargestEnergy) {
		energy = p_energy;
		emit_changed();
	}
}

void SkyObserver::set_outgoing(bool p_outgoing) {
	if (p_outgoing != outgoing) {
		outgoing = p_outgoing;
		emit_changed();
	}
}

void SkyObserver::set_axis(const Vector3 &p_axis) {
	if (p_axis != axis && p_axis.is_finite() && p_axis.length() > 0) {
		axis = p_axis;
		emit_changed();
	}
}

void SkyObserver::set_celerity(const Vector3 &p_celerity) {
	if (p_celerity != celerity && p_celerity.is_finite()) {
		celerity = p_celerity;
		emit_changed();
	}
}

void SkyObserver::set_relative_to_static(bool p_relative) {
	if (p_relative != relative_to_static) {
		relative_to_static = p_relative;
		emit_changed();
	}
}

double SkyObserver::energy_from_rest(double radius) {
	return radius > 1.0 ? blackhole::energy_from_rest(radius) : std::numeric_limits<double>::quiet_NaN();
}

Vector3 SkyObserver::celerity_from_velocity(const Vector3 &velocity) {
	const auto beta2 = static_cast<double>(velocity.length_squared());
	if (!(beta2 < 1.0)) {
		UtilityFunctions::push_error(
				"SkyObserver.celerity_from_velocity: a velocity must be below 1, that of light.");
		return {};
	}
	return velocity * static_cast<real_t>(1.0 / std::sqrt(1.0 - beta2));
}

String SkyObserver::get_refusal(const Vector3 &position) const {
	const auto at = blackhole::local_observer(field(), to_glm(position));
	return at ? String() : String::utf8(at.error.c_str());
}

Vector3 SkyObserver::celerity_at(const Vector3 &position) const {
	const auto at = blackhole::field_celerity(field(), to_glm(position));
	return at ? to_godot(*at.value) : Vector3();
}

Dictionary SkyObserver::shadow(const Vector3 &position) const {
	const auto found = blackhole::apparent_shadow(to_glm(position), field());
	Dictionary result;
	if (!found) {
		UtilityFunctions::push_error("SkyObserver.shadow: " + String::utf8(found.error.c_str()));
		return result;
	}
	result["direction"] = to_godot(found.value->centre);
	result["half_angle"] = found.value->half_angle;
	return result;
}

Dictionary SkyObserver::star_image(const Vector3 &position, const Vector3 &star, int order) const {
	return exact_star_image("SkyObserver", position, star, order, field());
}

Dictionary SkyObserver::trace(const Vector3 &position, const Vector3 &view_direction) const {
	return exact_trace("SkyObserver", position, view_direction, field());
}

Dictionary SkyObserver::disk_point(const Vector3 &position, const Vector3 &view_direction,
		const Vector3 &normal, int order, bool retrograde) const {
	return exact_disk_point(
			"SkyObserver", position, view_direction, {to_glm(normal), retrograde}, order, field());
}

Dictionary SkyObserver::plane_crossing(
		const Vector3 &place, const Vector3 &direction, const Vector3 &normal, int order) const {
	return exact_plane_crossing("SkyObserver", place, direction, normal, order, field());
}

void SkyObserver::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_motion", "motion"), &SkyObserver::set_motion);
	ClassDB::bind_method(D_METHOD("get_motion"), &SkyObserver::get_motion);
	ClassDB::bind_method(D_METHOD("set_energy", "energy"), &SkyObserver::set_energy);
	ClassDB::bind_method(D_METHOD("get_energy"), &SkyObserver::get_energy);
	ClassDB::bind_method(D_METHOD("set_outgoing", "outgoing"), &SkyObserver::set_outgoing);
	ClassDB::bind_method(D_METHOD("is_outgoing"), &SkyObserver::is_outgoing);
	ClassDB::bind_method(D_METHOD("set_axis", "axis"), &SkyObserver::set_axis);
	ClassDB::bind_method(D_METHOD("get_axis"), &SkyObserver::get_axis);
	ClassDB::bind_method(D_METHOD("set_celerity", "celerity"), &SkyObserver::set_celerity);
	ClassDB::bind_method(D_METHOD("get_celerity"), &SkyObserver::get_celerity);
	ClassDB::bind_method(
			D_METHOD("set_relative_to_static", "relative_to_static"), &SkyObserver::set_relative_to_static);
	ClassDB::bind_method(D_METHOD("is_relative_to_static"), &SkyObserver::is_relative_to_static);
	ClassDB::bind_static_method(
			"SkyObserver", D_METHOD("energy_from_rest", "radius"), &SkyObserver::energy_from_rest);
	ClassDB::bind_static_method("SkyObserver", D_METHOD("celerity_from_velocity", "velocity"),
			&SkyObserver::celerity_from_velocity);
	ClassDB::bind_method(D_METHOD("get_refusal", "position"), &SkyObserver::get_refusal);
	ClassDB::bind_method(D_METHOD("celerity_at", "position"), &SkyObserver::celerity_at);
	ClassDB::bind_method(D_METHOD("shadow", "position"), &SkyObserver::shadow);
	ClassDB::bind_method(D_METHOD("star_image", "position", "star", "order"), &SkyObserver::star_image);
	ClassDB::bind_method(D_METHOD("trace", "position", "view_direction"), &SkyObserver::trace);
	ClassDB::bind_method(
			D_METHOD("disk_point", "position", "view_direction", "normal", "order", "retrograde"),
			&SkyObserver::disk_point, DEFVAL(false));
	ClassDB::bind_method(D_METHOD("plane_crossing", "place", "direction", "normal", "order"),
			&SkyObserver::plane_crossing);

	ADD_PROPERTY(
			PropertyInfo(Variant::INT, "motion", PROPERTY_HINT_ENUM, "Static,Rain,Infall,Orbit,Velocity"),
			"set_motion", "get_motion");
	ADD_GROUP("Infall", "");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "energy", PROPERTY_HINT_RANGE,
						 String::utf8("0.001,10,0.001,or_greater,suffix:mc²")),
			"set_energy", "get_energy");
	ADD_PROPERTY(PropertyInfo(Variant::BOOL, "outgoing"), "set_outgoing", "is_outgoing");
	ADD_GROUP("Orbit", "");
	ADD_PROPERTY(PropertyInfo(Variant::VECTOR3, "axis"), "set_axis", "get_axis");
	ADD_GROUP("Velocity", "");
	ADD_PROPERTY(PropertyInfo(Variant::VECTOR3, "celerity", PROPERTY_HINT_NONE, "suffix:c"), "set_celerity",
			"get_celerity");
	ADD_PROPERTY(PropertyInfo(Variant::BOOL, "relative_to_static"), "set_relative_to_static",
			"is_relative_to_static");
}
