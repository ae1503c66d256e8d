// SPDX-License-Identifier: MIT
#include "src/circular_orbit_path.h"

#include <numbers>

#include <godot_cpp/variant/utility_functions.hpp>

#include "core/relativity/clocks.h"
#include "core/relativity/not_a_number.h"
#include "src/glm_adapter.h"

using namespace godot;

namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

} // namespace

Error CircularOrbitPath::start(const Vector3 &position, const Vector3 &axis) {
	const blackhole::Outcome<blackhole::CircularOrbit> made =
			blackhole::CircularOrbit::through(to_glm(position), to_glm(axis));
	if (!made) {
		error_message = "CircularOrbitPath: " + String::utf8(made.error.c_str()) + ".";
		UtilityFunctions::push_error(error_message);
		return ERR_INVALID_PARAMETER;
	}
	orbit = made.value;
	error_message = String();
	return OK;
}

double CircularOrbitPath::get_radius() const {
	return orbit ? orbit->radius() : blackhole::kNaN;
}

Vector3 CircularOrbitPath::get_axis() const {
	return orbit ? to_godot(orbit->axis()) : Vector3();
}

double CircularOrbitPath::get_energy() const {
	return orbit ? orbit->energy() : blackhole::kNaN;
}

double CircularOrbitPath::get_period() const {
	return orbit ? kTurn / orbit->proper_angular_velocity() : blackhole::kNaN;
}

double CircularOrbitPath::get_rain_period() const {
	return orbit ? kTurn / orbit->rain_angular_velocity() : blackhole::kNaN;
}

Vector3 CircularOrbitPath::position_at(double proper_time) const {
	return orbit ? to_godot(orbit->position_at(proper_time)) : Vector3();
}

Vector3 CircularOrbitPath::celerity_at(double proper_time) const {
	return orbit ? to_godot(orbit->celerity_at(proper_time)) : Vector3();
}

double CircularOrbitPath::rain_time_at(double proper_time) const {
	return orbit ? orbit->rain_time_at(proper_time) : blackhole::kNaN;
}

double CircularOrbitPath::far_clock_rate_at(double proper_time, const Vector3 &view_direction) const {
	if (!orbit) {
		return blackhole::kNaN;
	}
	return blackhole::far_clock_rate(
			orbit->position_at(proper_time), orbit->celerity_at(proper_time), to_glm(view_direction))
			.value.value_or(blackhole::kNaN);
}

void CircularOrbitPath::_bind_methods() {
	ClassDB::bind_method(D_METHOD("start", "position", "axis"), &CircularOrbitPath::start);
	ClassDB::bind_method(D_METHOD("is_ready"), &CircularOrbitPath::is_ready);
	ClassDB::bind_method(D_METHOD("get_error_message"), &CircularOrbitPath::get_error_message);
	ClassDB::bind_method(D_METHOD("get_radius"), &CircularOrbitPath::get_radius);
	ClassDB::bind_method(D_METHOD("get_axis"), &CircularOrbitPath::get_axis);
	ClassDB::bind_method(D_METHOD("is_stable"), &CircularOrbitPath::is_stable);
	ClassDB::bind_method(D_METHOD("get_energy"), &CircularOrbitPath::get_energy);
	ClassDB::bind_method(D_METHOD("get_period"), &CircularOrbitPath::get_period);
	ClassDB::bind_method(D_METHOD("get_rain_period"), &CircularOrbitPath::get_rain_period);
	ClassDB::bind_method(D_METHOD("position_at", "proper_time"), &CircularOrbitPath::position_at);
	ClassDB::bind_method(D_METHOD("celerity_at", "proper_time"), &CircularOrbitPath::celerity_at);
	ClassDB::bind_method(D_METHOD("rain_time_at", "proper_time"), &CircularOrbitPath::rain_time_at);
	ClassDB::bind_method(D_METHOD("far_clock_rate_at", "proper_time", "view_direction"),
			&CircularOrbitPath::far_clock_rate_at);
}
